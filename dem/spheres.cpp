#include "dem/spheres.hpp"

#include "dem/expect.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

double sphere_volume(double radius) {
  return 4.0 / 3.0 * pi * radius * radius * radius;
}

double sphere_inertia(double mass, double radius) {
  return 0.4 * mass * radius * radius;
}

void Spheres::add(Vec3 const& centre, double grain_radius, double density,
                  std::uint8_t grain_material, Vec3 const& grain_velocity, Vec3 const& grain_spin) {
  EXPECT(grain_radius > 0.0 && density > 0.0);
  id.push_back(static_cast<std::uint32_t>(size()));
  position.push_back(centre);
  velocity.push_back(grain_velocity);
  spin.push_back(grain_spin);
  force.emplace_back(Vec3::Zero());
  torque.emplace_back(Vec3::Zero());
  radius.push_back(grain_radius);
  mass.push_back(density * sphere_volume(grain_radius));
  material.push_back(grain_material);
}

double lens_volume(double radius_i, double radius_j, double distance) {
  double const sum = radius_i + radius_j;
  double const difference = radius_i - radius_j;
  if (distance >= sum)
    return 0.0;
  if (distance <= std::abs(difference))
    return sphere_volume(std::min(radius_i, radius_j));
  double const gap = sum - distance;
  return pi * gap * gap *
         (distance * distance + 2.0 * distance * sum - 3.0 * difference * difference) /
         (12.0 * distance);
}

} // namespace dem
