#include "dem/measure/energy.hpp"

#include <cstddef>

namespace dem {

KineticEnergy kinetic_energy(Spheres const& grains) {
  KineticEnergy energy{.translation = 0.0, .rotation = 0.0};
  for (std::size_t i = 0; i < grains.size(); ++i) {
    double const inertia = sphere_inertia(grains.mass[i], grains.radius[i]);
    energy.translation += 0.5 * grains.mass[i] * grains.velocity[i].squaredNorm();
    energy.rotation += 0.5 * inertia * grains.spin[i].squaredNorm();
  }
  return energy;
}

double gravity_energy(Spheres const& grains, Vec3 const& gravity) {
  double energy = 0.0;
  for (std::size_t i = 0; i < grains.size(); ++i)
    energy -= grains.mass[i] * gravity.dot(grains.position[i]);
  return energy;
}

Vec3 momentum(Spheres const& grains) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < grains.size(); ++i)
    sum += grains.mass[i] * grains.velocity[i];
  return sum;
}

} // namespace dem
