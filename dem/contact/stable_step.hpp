#pragma once

#include "dem/spheres.hpp"

#include <cstdint>
#include <vector>

namespace dem {

/// One contact as a linear spring and dashpot: what the stability of a step depends on.
struct LinearContact {
  static constexpr std::uint32_t wall = 0xffffffffu;
  std::uint32_t i, j;                            ///< rows; j = wall at a tool
  Vec3 normal;                                   ///< unit, from j to i
  double lever_i, lever_j;                       ///< [m], from the centres to the contact
  double normal_stiffness, tangential_stiffness; ///< [N/m]
  double normal_dashpot, tangential_dashpot;     ///< [kg/s]
};

/// Largest stable step [s] of velocity Verlet with dashpots evaluated at the half step:
///   dt = (2/w) (sqrt(1 + z^2) - z),  z = g / (2 w)
/// w^2 is the largest eigenvalue of M^-1 K and g that of M^-1 C over translations and spins of all
/// grains, found by power iteration. The iteration nears them from below, by less than a tenth in
/// the number of rounds taken here: use a safety factor of 0.8. Infinite where nothing touches.
/// Source of the damped limit: the half-step dashpot turns Verlet's w dt < 2 into w^2 dt^2 / 4 + g
/// dt / 2 < 1.
double stable_step(Spheres const& grains, std::vector<LinearContact> const& contacts);

} // namespace dem
