#pragma once

#include "dem/vec3.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dem {

/// The grains, as arrays of equal length n_grains. The order of the arrays may change (grains are
/// sorted along a space-filling curve); `id` is stable and names a grain for its whole life.
struct Spheres {
  std::vector<Vec3> position;         ///< [m], centre
  std::vector<Vec3> velocity;         ///< [m/s]
  std::vector<Vec3> spin;             ///< [rad/s]
  std::vector<Vec3> force;            ///< [N], of the last step, gravity included
  std::vector<Vec3> torque;           ///< [N m], of the last step
  std::vector<double> radius;         ///< [m], > 0
  std::vector<double> mass;           ///< [kg], > 0
  std::vector<std::uint8_t> material; ///< row of the MaterialTable
  std::vector<std::uint32_t> id;      ///< 0 .. n_grains - 1

  std::size_t size() const { return position.size(); }

  /// Appends a grain at rest.  mass = density 4/3 pi R^3
  void add(Vec3 const& centre, double grain_radius, double density, std::uint8_t grain_material,
           Vec3 const& grain_velocity = Vec3::Zero(), Vec3 const& grain_spin = Vec3::Zero());
};

/// 4/3 pi R^3 [m^3]
double sphere_volume(double radius);

/// 2/5 m R^2 [kg m^2]
double sphere_inertia(double mass, double radius);

/// Volume shared by two spheres whose centres are `distance` apart [m^3]; 0 when they do not touch,
/// the smaller sphere when one holds the other.
///   V = pi (Ri + Rj - r)^2 (r^2 + 2 r (Ri + Rj) - 3 (Ri - Rj)^2) / (12 r)
/// Source: Weisstein, "Sphere-Sphere Intersection", MathWorld.
double lens_volume(double radius_i, double radius_j, double distance);

} // namespace dem
