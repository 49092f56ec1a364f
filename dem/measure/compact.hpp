#pragma once

#include "dem/contact/contact.hpp"
#include "dem/spheres.hpp"

#include <cstddef>
#include <span>

namespace dem {

/// The compact is every grain whose centre lies above `floor`, the z of the lower punch's face [m]:
/// a grain that leaked or fell off the punch does not count.
bool is_in_compact(Spheres const& grains, std::size_t i, double floor);

/// How far the surfaces of the compact's grains reach along z.
struct Extent {
  double lowest;        ///< [m]
  double highest;       ///< [m]
  std::size_t n_grains; ///< 0: lowest and highest are the floor

  double height() const { return highest - lowest; }
};

Extent compact_extent(Spheres const& grains, double floor);

/// The height [m] that `share` of the grains keep below: the surface at rank ceil(share n) of the
/// tops, minus the lowest surface. A few thrown grains do not lift it.
double ranked_height(Spheres const& grains, double floor, double share = 0.999);

/// Volume of the compact's grains less their overlaps [m^3]:  sum 4/3 pi R^3 - sum lens.
/// A place covered by three grains is subtracted once too often, as in the seed's definition.
double solid_volume(Spheres const& grains, ContactStream const& contacts, double floor);

/// Porosity of the seed paper:  P = 1 - V_solid / (pi r^2 h),  h = highest minus lowest grain
/// surface.
struct SeedPorosity {
  double porosity;        ///< [1]; 1 where there is no grain
  double height;          ///< [m]
  double ranked_porosity; ///< [1], with the height at rank 99.9 %
  double ranked_height;   ///< [m]
  double solid_volume;    ///< [m^3]
  std::size_t n_grains;
};

/// @param bore_radius  r [m], of the die, as the seed takes it also when the die is gone
/// Source: Ramirez-Aragon et al., Metals 10 (2020), section 2.3; contact-law notes, section 5.
SeedPorosity seed_porosity(Spheres const& grains, ContactStream const& contacts, double bore_radius,
                           double floor);

} // namespace dem
