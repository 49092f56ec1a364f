#pragma once

#include "dem/spheres.hpp"

#include <cstddef>

namespace dem {

/// What acts on one grain.
struct GrainLoad {
  Vec3 force;  ///< [N]
  Vec3 torque; ///< [N m], about its centre
};

/// Half a kick of velocity Verlet:  v += dt/2 F/m,  w += dt/2 T/I,  I = 2/5 m R^2.
inline void half_kick(Spheres& grains, std::size_t i, GrainLoad const& load, double dt) {
  double const square = grains.radius[i] * grains.radius[i];
  double const half_over_inertia = 0.5 * dt * 2.5 / (grains.mass[i] * square);
  double const half_over_mass = 0.4 * square * half_over_inertia; // one division for both
  grains.velocity[i] += half_over_mass * load.force;
  grains.spin[i] += half_over_inertia * load.torque;
}

} // namespace dem
