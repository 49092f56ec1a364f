#pragma once

#include "dem/packing/packing.hpp"

#include <cstdint>
#include <span>

namespace crosscode {

/// The seed's powder in a cylinder standing on z = 0: MgO (3500 kg/m^3, 80 % of the mass) with
/// 35/25/25/15 % of it at 0.5/1/2/3 mm, Al2O3 (3000 kg/m^3) at 0.5 mm.
struct Bed {
  double bore_diameter; ///< [m]
  double height;        ///< [m], of the cylinder that is filled
  double total_mass;    ///< [kg]
  std::uint64_t seed;
};

/// MgO and Al2O3, in the order of the packing's components.
std::span<dem::PackingComponent const> seed_components();

/// Grains at rest that do not touch, largest first, as dense as a shaken bed (up to 0.64 solid):
/// they start anywhere and push one another apart. So the punch meets resistance at once, and a
/// comparison of codes needs no long way through free flight, where rounding alone makes
/// trajectories part.
/// @throws std::runtime_error if they still overlap after many sweeps
dem::Packing dense_bed(Bed const& bed);

/// Touching pairs counted at both partners, per grain: the coordination number Z.
double coordination(dem::Packing const& packing);

/// Highest minus lowest grain surface [m]: the seed's height of a compact.
double extent(dem::Packing const& packing);

} // namespace crosscode
