#include "dem/step/crush.hpp"

#include "dem/step/advance.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace dem {

namespace {

/// A turn that favours no direction. Source: Shoemake, Graphics Gems III (1992), 124.
Eigen::Matrix3d random_turn(std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  // The library's distributions differ from one to the next.
  auto const uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
  double const u = uniform(), a = 2.0 * pi * uniform(), b = 2.0 * pi * uniform();
  Eigen::Quaterniond const turn(std::sqrt(u) * std::cos(b), std::sqrt(1.0 - u) * std::sin(a),
                                std::sqrt(1.0 - u) * std::cos(a), std::sqrt(u) * std::sin(b));
  return turn.toRotationMatrix();
}

} // namespace

std::array<Fragment, 14> const& fragments() {
  static auto const all = [] {
    std::array<Fragment, 14> made;
    double const r = std::sqrt(2.0) - 1.0, c = 1.0 - r, root = std::sqrt(3.0);
    double const s = (1.0 - 2.0 * c / root + c * c - r * r) / (2.0 + 2.0 * r - 2.0 * c / root);
    for (std::size_t k = 0; k < 6; ++k)
      made[k] = {(k % 2 == 0 ? c : -c) * Vec3::Unit(static_cast<int>(k / 2)), r};
    for (std::size_t k = 0; k < 8; ++k) {
      Vec3 const corner(k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0);
      made[6 + k] = {(1.0 - s) / root * corner, s};
    }
    return made;
  }();
  return all;
}

Dust crush(World& world, std::span<std::uint32_t const> rows, std::uint64_t seed) {
  complete_step(world);
  world.contacts.forget(rows);
  Spheres& g = world.grains;
  Dust dust;
  for (std::uint32_t const row : rows) {
    Vec3 const x = g.position[row], v = g.velocity[row], w = g.spin[row];
    double const R = g.radius[row], density = g.mass[row] / sphere_volume(R);
    Eigen::Matrix3d const turn = random_turn(seed + g.id[row]);
    dust.mass += g.mass[row];
    dust.volume += sphere_volume(R);
    dust.momentum += g.mass[row] * v;
    for (std::size_t k = 0; k < fragments().size(); ++k) {
      Vec3 const arm = R * (turn * fragments()[k].centre);
      Vec3 const velocity = v + w.cross(arm);
      double const radius = R * fragments()[k].radius, volume = sphere_volume(radius);
      if (k > 0)
        g.add(x + arm, radius, density, g.material[row], velocity, w);
      else
        g.position[row] = x + arm, g.velocity[row] = velocity, g.radius[row] = radius,
        g.mass[row] = density * volume;
      dust.mass -= density * volume;
      dust.volume -= volume;
      dust.momentum -= density * volume * velocity;
    }
  }
  prepare(world);
  return dust;
}

} // namespace dem
