#include "tests/support/world_builders.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <string>

/// Every parameter of materials, interactions and laws moves the outcome: a parameter that is read
/// and then ignored would pass every other test.
namespace {

using dem::Vec3;
using R = build::Recipe&;

struct Knob {
  std::string name;
  std::function<void(R)> turn;
  std::function<void(R)> before = [](R) {}; ///< what the knob needs to have a say, in both runs

  friend std::ostream& operator<<(std::ostream& out, Knob const& knob) { return out << knob.name; }
};

void use_hooke(R r) {
  r.law.normal = "hooke";
  r.law.tangential = "hooke_spring";
}
void use_jkr(R r) {
  r.law.normal = "jkr";
  r.law.cohesion = "none";
}
void use_thornton_ning(R r) {
  r.law.normal = "thornton_ning";
  r.law.yield_pressure = 3e6;
}
void use_edinburgh(R r) {
  r.law.normal = "edinburgh";
  r.law.cohesion = "none";
  r.law.plasticity_ratio = 0.5;
}
void use_rolling(R r) {
  r.law.rolling = "constant_torque";
}

std::vector<Knob> knobs() {
  return {
      {"grain_density", [](R r) { r.grain.density *= 1.1; }},
      {"grain_young_modulus", [](R r) { r.grain.young_modulus *= 1.1; }},
      {"grain_poisson_ratio", [](R r) { r.grain.poisson_ratio = 0.3; }},
      {"wall_young_modulus", [](R r) { r.wall.young_modulus *= 1.1; }},
      {"wall_poisson_ratio", [](R r) { r.wall.poisson_ratio = 0.35; }},
      {"grain_grain_restitution", [](R r) { r.grain_grain.restitution = 0.6; }},
      {"grain_grain_static_friction", [](R r) { r.grain_grain.static_friction *= 0.5; }},
      {"grain_grain_rolling_friction", [](R r) { r.grain_grain.rolling_friction *= 2.0; },
       use_rolling},
      {"grain_grain_cohesion", [](R r) { r.grain_grain.cohesion_energy_density *= 1.1; }},
      {"grain_grain_surface_energy", [](R r) { r.grain_grain.surface_energy *= 1.1; }, use_jkr},
      {"grain_wall_restitution", [](R r) { r.grain_wall.restitution = 0.6; }},
      {"grain_wall_static_friction", [](R r) { r.grain_wall.static_friction *= 0.5; }},
      {"grain_wall_rolling_friction", [](R r) { r.grain_wall.rolling_friction *= 2.0; },
       use_rolling},
      {"grain_wall_cohesion", [](R r) { r.grain_wall.cohesion_energy_density *= 1.1; }},
      {"grain_wall_surface_energy", [](R r) { r.grain_wall.surface_energy *= 1.1; }, use_jkr},
      {"normal_hooke", use_hooke},
      {"normal_jkr", use_jkr, [](R r) { r.law.cohesion = "none"; }},
      {"normal_thornton_ning", use_thornton_ning},
      {"normal_edinburgh", use_edinburgh, [](R r) { r.law.cohesion = "none"; }},
      {"yield_pressure", [](R r) { r.law.yield_pressure *= 1.1; }, use_thornton_ning},
      {"plasticity_ratio", [](R r) { r.law.plasticity_ratio = 0.6; }, use_edinburgh},
      {"adhesion_exponent", [](R r) { r.law.adhesion_exponent = 5.0; }, use_edinburgh},
      {"edinburgh_surface_energy", [](R r) { r.grain_grain.surface_energy *= 1.1; }, use_edinburgh},
      {"viscous_time", [](R r) { r.law.viscous_time = 1e-6; }},
      {"multi_contact", [](R r) { r.law.multi_contact = 1.0; }},
      {"cohesion_none", [](R r) { r.law.cohesion = "none"; }},
      {"cohesion_sjkr", [](R r) { r.law.cohesion = "sjkr"; }},
      {"cohesion_linear_reduced", [](R r) { r.law.cohesion = "linear_reduced"; }},
      {"cohesion_linear_hertz_circle", [](R r) { r.law.cohesion = "linear_hertz_circle"; }},
      {"tangential_frictionless", [](R r) { r.law.tangential = "frictionless"; }},
      {"tangential_hooke_spring", use_hooke,
       [](R r) {
         r.law.normal = "hooke";
         r.law.tangential = "frictionless";
       }},
      {"rolling_constant_torque", use_rolling},
      {"friction_limit", [](R r) { r.law.friction_limit = "elastic"; }},
      {"tangential_damping", [](R r) { r.law.tangential_damping = false; }},
      {"clip_attractive_damping", [](R r) { r.law.clip_attractive_damping = true; }},
      {"characteristic_velocity", [](R r) { r.law.characteristic_velocity = 0.5; }, use_hooke},
      {"precision", [](R r) { r.law.precision = dem::Precision::mixed; }},
      {"gravity", [](R r) { r.gravity.x() += 1.0; }},
  };
}

/// A few dozen grains meet each other and a moving plate, obliquely and spinning, and some part
/// again.
dem::World outcome(build::Recipe const& recipe) {
  dem::World world = build::empty_world(recipe);
  build::add_cloud(world, {.n_grains = 40,
                           .smallest = 0.25e-3,
                           .largest = 0.5e-3,
                           .high = Vec3::Constant(2.2e-3),
                           .relative_overlap = 0.03,
                           .speed = 0.6});
  build::add_plane(world, nullptr, Vec3(1e-3, 1e-3, 0.1e-3), Vec3::UnitZ(), Vec3(0.1, 0, 0.3),
                   10e-3);
  dem::prepare(world);
  for (int k = 0; k < 400; ++k)
    dem::advance(world, 4e-7);
  return world;
}

class Parameter : public ::testing::TestWithParam<Knob> {};

TEST_P(Parameter, MovesTheOutcome) {
  build::Recipe base;
  base.grain_grain = {.restitution = 0.5,
                      .static_friction = 0.3,
                      .rolling_friction = 0.05,
                      .cohesion_energy_density = 2e6,
                      .surface_energy = 1.0};
  base.grain_wall = base.grain_grain;
  base.law.precision = dem::Precision::full;
  GetParam().before(base);
  build::Recipe turned = base;
  GetParam().turn(turned);
  dem::World const a = outcome(base), b = outcome(turned);
  double change = 0.0, travel = 0.0;
  for (std::uint32_t id = 0; id < a.grains.size(); ++id) {
    std::size_t const i = build::row_of(a, id), j = build::row_of(b, id);
    change = std::max(change, (a.grains.velocity[i] - b.grains.velocity[j]).norm());
    travel = std::max(travel, a.grains.velocity[i].norm());
  }
  // Single precision alone moves 1e-7; a real effect far more.
  double const least = GetParam().name == "precision" ? 1e-12 : 1e-5;
  EXPECT_GT(change, least * travel);
  EXPECT_LT(change, 10.0 * travel) << "and the run stays a run";
}

INSTANTIATE_TEST_SUITE_P(Every, Parameter, ::testing::ValuesIn(knobs()),
                         [](auto const& p) { return p.param.name; });

} // namespace
