#pragma once

#include "dem/step/world.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace dem {

/// One of the spheres that a crushed grain falls into, for a grain of radius 1 about the origin.
struct Fragment {
  Vec3 centre;
  double radius;
};

/// Fourteen spheres inside the unit sphere that touch it and do not overlap: six of radius
/// r = sqrt(2) - 1 on the axes, which touch each other, and eight of radius s on the diagonals,
/// each between three of them and the surface:
///   c = 1 - r,   s = (1 - 2 c / sqrt(3) + c^2 - r^2) / (2 + 2 r - 2 c / sqrt(3)) = 0.2301.
/// They hold 52.4 % of the volume; the rest is dust, which is no grain any more.
/// Source of the fourteen: Ciantia, Arroyo, Calvetti and Gens, Geotechnique 65 (2015) 489.
std::array<Fragment, 14> const& fragments();

/// What crushing turned into dust.
struct Dust {
  double mass = 0.0;            ///< [kg]
  double volume = 0.0;          ///< [m^3]
  Vec3 momentum = Vec3::Zero(); ///< [N s]
};

/// Replaces grains by their fragments, which move as the grain did and are turned at random. The
/// first takes the grain's row and id, the others follow behind all rows with new ids. Histories of
/// the grain's contacts are forgotten; forces are those of the new state when it returns.
/// @param rows  of different grains, between steps, in an order that does not depend on rows
/// @param seed  of the turns
Dust crush(World& world, std::span<std::uint32_t const> rows, std::uint64_t seed);

} // namespace dem
