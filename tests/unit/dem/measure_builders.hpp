#pragma once

#include "dem/contact/contact.hpp"
#include "dem/spheres.hpp"

#include <cmath>
#include <vector>

/// Small beds and contacts with known answers.
namespace dem::test {

/// The contact of two grains that overlap, with the force on i.
inline Contact touch(Spheres const& grains, std::uint32_t i, std::uint32_t j, Vec3 const& force) {
  Vec3 const between = grains.position[i] - grains.position[j];
  Vec3 const n = between.normalized();
  double const overlap = grains.radius[i] + grains.radius[j] - between.norm();
  Contact contact{};
  contact.i = i;
  contact.j = j;
  contact.tool = contact.patch = contact.triangle = Contact::none;
  contact.point = grains.position[i] - n * (grains.radius[i] - 0.5 * overlap);
  contact.normal = n;
  contact.overlap = overlap;
  contact.normal_force = force.dot(n);
  contact.tangential_force = force - force.dot(n) * n;
  contact.force = force;
  return contact;
}

/// The contact of a grain with tool 0 at `point`, with the force on the grain.
inline Contact touch_tool(Spheres const& grains, std::uint32_t i, Vec3 const& point,
                          Vec3 const& force) {
  Contact contact{};
  contact.i = i;
  contact.j = Contact::none;
  contact.tool = contact.patch = contact.triangle = 0;
  contact.point = point;
  contact.normal = (grains.position[i] - point).normalized();
  contact.overlap = grains.radius[i] - (grains.position[i] - point).norm();
  contact.force = force;
  return contact;
}

/// Simple cubic lattice of touching grains of diameter d, one centre at `shift`, those for which
/// keep(centre).
template <class Keep>
Spheres simple_cubic(double d, int half_width, int n_layers, Vec3 const& shift, Keep&& keep) {
  Spheres grains;
  for (int k = 0; k < n_layers; ++k)
    for (int j = -half_width; j <= half_width; ++j)
      for (int i = -half_width; i <= half_width; ++i)
        if (Vec3 const centre = shift + d * Vec3(i, j, k); keep(centre))
          grains.add(centre, 0.5 * d, 3000.0, 0);
  return grains;
}

inline bool keep_all(Vec3 const&) {
  return true;
}

} // namespace dem::test
