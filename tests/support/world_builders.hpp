#pragma once

#include "coupling/verification/setups.hpp"
#include "dem/step/visit_state.hpp"
#include "tests/support/oracles/contact_law.hpp"

#include <Eigen/Geometry>

#include <cstdint>
#include <random>
#include <vector>

/// Worlds for tests, and the oracle's image of a world.
namespace build {

using coupling::verification::add_tool;
using coupling::verification::empty_world;
using coupling::verification::plate;
using coupling::verification::Recipe;
using coupling::verification::row_of;
using coupling::verification::turned;

inline oracle::Cohesion cohesion_named(std::string const& name) {
  if (name == "sjkr")
    return oracle::Cohesion::sjkr;
  if (name == "sjkr2")
    return oracle::Cohesion::sjkr2;
  if (name == "linear_reduced")
    return oracle::Cohesion::linear_reduced;
  if (name == "linear_hertz_circle")
    return oracle::Cohesion::linear_hertz_circle;
  return oracle::Cohesion::none;
}

inline oracle::Law law_of(dem::ContactChoice const& choice, dem::Material const& i,
                          dem::Material const& j, dem::Interaction const& interaction) {
  return {.i = {i.young_modulus, i.poisson_ratio},
          .j = {j.young_modulus, j.poisson_ratio},
          .restitution = interaction.restitution,
          .friction = interaction.static_friction,
          .rolling_friction = choice.rolling == "none" ? 0.0 : interaction.rolling_friction,
          .cohesion_energy_density = interaction.cohesion_energy_density,
          .normal = choice.normal == "hooke" ? oracle::Normal::hooke : oracle::Normal::hertz,
          .cohesion = cohesion_named(choice.cohesion),
          .tangential = choice.tangential == "frictionless" ? oracle::Tangential::frictionless
                                                            : oracle::Tangential::history,
          .cohesion_limits_friction = choice.friction_limit == "net",
          .tangential_dashpot = choice.tangential_damping,
          .clip_tension = choice.clip_attractive_damping,
          .characteristic_velocity = choice.characteristic_velocity};
}

/// The oracle's picture of a world's grains, in the order of their ids. Planes are added by the
/// caller, because the oracle must not trust the surface code.
inline oracle::System mirror(dem::World const& world, Recipe const& recipe) {
  oracle::System system;
  system.gravity = world.gravity.cast<oracle::Real>();
  system.laws[{0, 0}] = law_of(recipe.law, recipe.grain, recipe.grain, recipe.grain_grain);
  system.laws[{0, 1}] = law_of(recipe.law, recipe.grain, recipe.wall, recipe.grain_wall);
  dem::Spheres const& grains = world.grains;
  for (std::uint32_t id = 0; id < grains.size(); ++id) {
    std::size_t const row = row_of(world, id);
    system.bodies.push_back({.x = grains.position[row].cast<oracle::Real>(),
                             .v = grains.velocity[row].cast<oracle::Real>(),
                             .w = grains.spin[row].cast<oracle::Real>(),
                             .R = grains.radius[row],
                             .m = grains.mass[row]});
  }
  return system;
}

/// A plate as tool and as the oracle's plane: its face has unit normal `normal` and passes through
/// `point`.
inline void add_plane(dem::World& world, oracle::System* system, dem::Vec3 const& point,
                      dem::Vec3 const& normal, dem::Vec3 const& velocity, double half_width,
                      int n_cells = 1) {
  Eigen::Matrix3d const rotation =
      Eigen::Quaterniond::FromTwoVectors(dem::Vec3::UnitZ(), normal).toRotationMatrix();
  add_tool(world, "plane " + std::to_string(world.tools.size()),
           turned(plate(half_width, 0.2 * half_width, n_cells), rotation), point, velocity);
  if (system != nullptr) {
    system->planes.push_back({.point = point.cast<oracle::Real>(),
                              .normal = normal.cast<oracle::Real>(),
                              .v = velocity.cast<oracle::Real>()});
  }
}

struct Cloud {
  int n_grains = 300;
  double smallest = 0.25e-3; ///< [m], radius
  double largest = 0.25e-3;  ///< [m], radius
  dem::Vec3 low = dem::Vec3::Zero();
  dem::Vec3 high = dem::Vec3::Constant(4e-3); ///< [m], box of the surfaces
  double relative_overlap = 0.1;              ///< [1], allowed at the start, of the smaller radius
  double speed = 0.2;                         ///< [m/s], largest of a component
  double spin = 200.0;                        ///< [rad/s], largest of a component
  std::uint64_t seed = 1;
};

/// Grains at random places of a box, log-uniform radii, random velocities and spins. Gives up
/// adding after many vain tries, so the number of grains may be smaller than asked for in a crowded
/// box.
inline void add_cloud(dem::World& world, Cloud const& cloud) {
  std::mt19937_64 random(cloud.seed);
  auto const uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  auto const any = [&](double size) {
    return dem::Vec3(uniform(-size, size), uniform(-size, size), uniform(-size, size));
  };
  double const density = world.materials[0].density;
  std::vector<double> radii;
  for (int k = 0; k < cloud.n_grains; ++k) {
    radii.push_back(cloud.smallest * std::pow(cloud.largest / cloud.smallest, uniform(0.0, 1.0)));
  }
  std::sort(radii.begin(), radii.end(), std::greater<>());
  for (double const R : radii) {
    for (int attempt = 0; attempt < 2000; ++attempt) {
      dem::Vec3 const x(uniform(cloud.low.x() + R, cloud.high.x() - R),
                        uniform(cloud.low.y() + R, cloud.high.y() - R),
                        uniform(cloud.low.z() + R, cloud.high.z() - R));
      bool free = true;
      for (std::size_t k = 0; k < world.grains.size() && free; ++k) {
        double const allowed = cloud.relative_overlap * std::min(R, world.grains.radius[k]);
        free = (x - world.grains.position[k]).norm() > R + world.grains.radius[k] - allowed;
      }
      if (!free)
        continue;
      world.grains.add(x, R, density, 0, any(cloud.speed), any(cloud.spin));
      break;
    }
  }
}

} // namespace build
