#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace dem {

/// The part of a powder that has one size and one component, by mass.
struct GrainShare {
  double diameter;        ///< [m], > 0
  double density;         ///< [kg/m^3], > 0
  std::uint8_t material;  ///< row of the MaterialTable
  std::uint8_t component; ///< row of the powder's components
  double mass_fraction;   ///< [1], of the whole powder, >= 0; all shares sum to 1
};

/// The same part as a number of equal grains.
struct GrainClass {
  double diameter;        ///< [m], > 0
  double density;         ///< [kg/m^3], > 0
  std::uint8_t material;  ///< row of the MaterialTable
  std::uint8_t component; ///< row of the powder's components
  std::uint64_t count;    ///< may be 0 where a share is below half a grain
};

/// Mass of one grain of a class [kg]:  density pi/6 d^3
double grain_mass(GrainClass const& grains);

/// Mass of all grains [kg], and their volume [m^3].
double total_mass(std::span<GrainClass const> classes);
double solid_volume(std::span<GrainClass const> classes);

/// Whole grains for every share of `mass`. Each class is rounded to its nearest count; then the
/// lightest class of each component takes up what that component still lacks, and the lightest of
/// all what the powder lacks. So
///  - the powder's mass is met within half of the lightest grain,
///  - every component's mass within half of its lightest grain, but for that last correction,
///  - every class within half of one of its grains, but for the lightest of each component, which
///  differs by what
///    the rounding of the heavier ones amounts to.
/// Where rounding up leaves a component too much mass for its lightest class, its heavier classes
/// round down.
/// @param shares  mass fractions summing to 1 within 1e-9
/// @param mass    [kg], > 0
/// @returns       one class for each share, in the same order
/// @throws InvalidInput if a share or the mass is not usable, or the mass is below half of the
/// lightest grain
std::vector<GrainClass> count_grains(std::span<GrainShare const> shares, double mass);

} // namespace dem
