#pragma once

#include "dem/spheres.hpp"

namespace dem {

/// Kinetic energy [J]: translation sum 1/2 m v^2, rotation sum 1/2 (2/5 m R^2) w^2.
struct KineticEnergy {
  double translation;
  double rotation;

  double total() const { return translation + rotation; }
};

KineticEnergy kinetic_energy(Spheres const& grains);

/// Potential energy in gravity [J], zero at the origin:  -sum m g . x
double gravity_energy(Spheres const& grains, Vec3 const& gravity);

/// Total momentum [kg m/s]:  sum m v
Vec3 momentum(Spheres const& grains);

} // namespace dem
