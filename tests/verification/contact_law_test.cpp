#include "tests/support/near.hpp"
#include "tests/support/world_builders.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <cstddef>
#include <functional>
#include <ostream>
#include <string>

/// The engine against the law restated and integrated independently
/// (tests/support/oracles/contact_law.hpp): x, v, w, F and T of every grain at every step, 1e-10 of
/// the largest value in full precision, 2e-4 in mixed. Experiments are chosen well-conditioned: a
/// cohesive pair that rings for thousands of steps near its zero-force overlap, or whose rolling
/// torque chatters about rest, multiplies the rounding of a double's positions to 1e-9 (so does
/// this oracle when it is compiled in double). They part, or run for the two thousand steps before
/// that.
namespace {

using dem::Vec3;

/// One experiment: two grains, or one grain over a moving plane.
struct Experiment {
  std::string name;
  int steps = 3000;
  bool on_plane = false;
  Vec3 velocity = Vec3::Zero(); ///< [m/s], of grain 0; grain 1 starts at minus a fifth of it
  Vec3 spin = Vec3::Zero();     ///< [rad/s], of grain 0; grain 1 has minus a third of it
  double gap = 2.037e-6; ///< [m], at the start; no multiple of a step's travel: touch must not hang
                         ///< on rounding
  std::function<void(build::Recipe&)> modify = [](build::Recipe&) {};

  friend std::ostream& operator<<(std::ostream& out, Experiment const& e) { return out << e.name; }
};

void cohesive(build::Recipe& recipe) {
  recipe.grain_grain.cohesion_energy_density = 5e6;
  recipe.grain_wall.cohesion_energy_density = 2e6;
}

std::vector<Experiment> experiments() {
  // 0.2 m/s head-on along a skew line, so that no component of any vector is zero by luck.
  Vec3 const head_on = -0.2 * Vec3(1, 2, 2) / 3;
  Vec3 const oblique = Vec3(-0.12, 0.05, -0.16);
  Vec3 const spinning = Vec3(310, -170, 240);
  Vec3 const down = Vec3(0.3, -0.1, -0.15);
  auto const with = [](auto change) {
    return [change](build::Recipe& recipe) {
      cohesive(recipe);
      change(recipe);
    };
  };
  using R = build::Recipe&;
  return {
      {.name = "head_on", .velocity = head_on, .modify = [](R r) { r.law.cohesion = "none"; }},
      {.name = "oblique_with_spins",
       .velocity = oblique,
       .spin = spinning,
       .modify = [](R r) { r.law.cohesion = "none"; }},
      {.name = "sjkr2_net_limit", .velocity = oblique, .spin = spinning, .modify = cohesive},
      {.name = "sjkr2_elastic_limit",
       .velocity = oblique,
       .spin = spinning,
       .modify = with([](R r) { r.law.friction_limit = "elastic"; })},
      {.name = "sjkr", .velocity = oblique, .spin = spinning, .modify = with([](R r) {
                                                                r.law.cohesion = "sjkr";
                                                              })},
      {.name = "linear_reduced", .velocity = oblique, .spin = spinning, .modify = with([](R r) {
                                                                          r.law.cohesion =
                                                                              "linear_reduced";
                                                                        })},
      {.name = "linear_hertz_circle",
       .steps = 2000,
       .velocity = oblique,
       .spin = spinning,
       .modify = with([](R r) { r.law.cohesion = "linear_hertz_circle"; })},
      {.name = "no_tangential_dashpot",
       .velocity = oblique,
       .spin = spinning,
       .modify = with([](R r) { r.law.tangential_damping = false; })},
      {.name = "clipped_tension",
       .velocity = oblique,
       .spin = spinning,
       .modify =
           [](R r) {
             r.law.cohesion = "none";
             r.law.clip_attractive_damping = true;
           }},
      {.name = "frictionless", .velocity = oblique, .spin = spinning, .modify = with([](R r) {
                                                                        r.law.tangential =
                                                                            "frictionless";
                                                                      })},
      {.name = "sticking_high_friction",
       .steps = 2000,
       .velocity = oblique,
       .spin = spinning,
       .modify = with([](R r) { r.grain_grain.static_friction = 5.0; })},
      {.name = "spinning_in_place_cohesive",
       .spin = Vec3(900, 200, -400),
       .gap = -8e-6,
       .modify = cohesive},
      {.name = "rolling_friction",
       .steps = 2000,
       .velocity = oblique,
       .spin = 10.0 * spinning,
       .modify = with([](R r) {
         r.law.rolling = "constant_torque";
         r.grain_grain.rolling_friction = 0.01;
         r.law.cohesion = "none";
       })},
      {.name = "hooke",
       .velocity = oblique,
       .spin = spinning,
       .modify = with([](R r) {
         r.law.normal = "hooke";
         r.law.tangential = "hooke_spring";
         r.grain_grain.cohesion_energy_density =
             2e5; // its slope must stay below the spring's, 2.8e3 N/m
       })},
      {.name = "plane_sliding_and_spinning",
       .on_plane = true,
       .velocity = down,
       .spin = spinning,
       .modify = [](R r) { r.law.cohesion = "none"; }},
      {.name = "plane_cohesive",
       .on_plane = true,
       .velocity = down,
       .spin = spinning,
       .modify = cohesive},
      {.name = "plane_cohesive_sjkr",
       .on_plane = true,
       .velocity = down,
       .spin = spinning,
       .modify = with([](R r) { r.law.cohesion = "sjkr"; })},
      {.name = "plane_elastic_limit",
       .on_plane = true,
       .velocity = down,
       .spin = spinning,
       .modify = with([](R r) { r.law.friction_limit = "elastic"; })},
      {.name = "plane_rolling_friction",
       .on_plane = true,
       .velocity = down,
       .spin = spinning,
       .modify = with([](R r) {
         r.law.rolling = "constant_torque";
         r.grain_wall.rolling_friction = 0.08;
       })},
      {.name = "plane_under_gravity_at_rest",
       .on_plane = true,
       .velocity = Vec3(0.05, 0, -0.02),
       .modify = with([](R r) { r.gravity = Vec3(1.0, -2.0, -9.0); })},
  };
}

struct Deviations {
  near::LargestDeviation x{"position"}, v{"velocity"}, w{"spin"}, F{"force"}, T{"torque"},
      tool{"tool force"};
  int steps_in_contact = 0;
};

/// Runs both sides in step. dt = 4e-7 s is 8.5 % of the Rayleigh time of the smaller grain.
Deviations run(Experiment const& e, dem::Precision precision) {
  omp_set_num_threads(1); // two grains: a team of threads would only wait
  build::Recipe recipe;
  recipe.grain_wall.static_friction = 0.3;
  recipe.grain_wall.restitution = 0.6;
  e.modify(recipe);
  recipe.law.precision = precision;

  dem::World world = build::empty_world(recipe);
  double const R0 = 0.25e-3, R1 = 1.5e-3, dt = 4e-7;
  if (e.on_plane) {
    world.grains.add(Vec3(1e-3, -2e-3, R0 + e.gap), R0, recipe.grain.density, 0, e.velocity,
                     e.spin);
  } else {
    Vec3 const away = (R0 + R1 + e.gap) * Vec3(1, 2, 2) / 3;
    world.grains.add(away, R0, recipe.grain.density, 0, e.velocity, e.spin);
    world.grains.add(Vec3::Zero(), R1, recipe.grain.density, 0, -0.2 * e.velocity, -e.spin / 3.0);
  }
  oracle::System system = build::mirror(world, recipe);
  if (e.on_plane) {
    build::add_plane(world, &system, Vec3::Zero(), Vec3::UnitZ(), Vec3(0.02, -0.03, 0.1), 20e-3, 3);
  }

  dem::prepare(world);
  system.gather(0);
  Deviations result;
  for (int k = 0; k < e.steps; ++k) {
    dem::advance(world, dt);
    system.step(dt);
    for (std::uint32_t id = 0; id < world.grains.size(); ++id) {
      std::size_t const row = build::row_of(world, id);
      oracle::Body const& body = system.bodies[id];
      result.x.add(world.grains.position[row], body.x.cast<double>());
      result.v.add(world.grains.velocity[row], body.v.cast<double>());
      result.w.add(world.grains.spin[row], body.w.cast<double>());
      result.F.add(world.grains.force[row], body.F.cast<double>());
      result.T.add(world.grains.torque[row], body.T.cast<double>());
    }
    if (e.on_plane)
      result.tool.add(world.tools[0].force, system.planes[0].F.cast<double>());
    result.steps_in_contact += system.n_contacts() > 0;
  }
  return result;
}

void expect_within(Deviations const& d, double tolerance) {
  EXPECT_GT(d.steps_in_contact, 50) << "the experiment must press the grains together";
  EXPECT_TRUE(d.x.within(tolerance));
  EXPECT_TRUE(d.v.within(tolerance));
  // Head-on, spin and torque are exactly zero in theory: a thousandth of v/R and of R F is then
  // their scale.
  double const R = 0.25e-3;
  EXPECT_TRUE(d.w.within(tolerance, 1e-3 * d.v.largest() / R));
  EXPECT_TRUE(d.F.within(tolerance));
  EXPECT_TRUE(d.T.within(tolerance, 1e-3 * R * d.F.largest()));
  EXPECT_TRUE(d.tool.within(tolerance));
}

class ContactLaw : public ::testing::TestWithParam<Experiment> {};

TEST_P(ContactLaw, FollowsTheRestatedEquationsInFullPrecision) {
  Deviations const d = run(GetParam(), dem::Precision::full);
  expect_within(d, 1e-10);
  for (auto const& [name, deviation] :
       {std::pair{"x", &d.x}, {"v", &d.v}, {"w", &d.w}, {"F", &d.F}, {"T", &d.T}}) {
    RecordProperty(name, std::to_string(deviation->ratio() * 1e15) + "e-15");
  }
}

// Single-precision forces carry 6e-8 each; thousands of steps of one contact integrate them to a
// few 1e-6, and a stick-slip change that falls one step earlier or later to a few 1e-5 of the
// largest force.
TEST_P(ContactLaw, FollowsTheRestatedEquationsInMixedPrecision) {
  expect_within(run(GetParam(), dem::Precision::mixed), 2e-4);
}

INSTANTIATE_TEST_SUITE_P(Pair, ContactLaw, ::testing::ValuesIn(experiments()),
                         [](auto const& parameter) { return parameter.param.name; });

} // namespace
