#include "coupling/verification/benchmarks.hpp"
#include "coupling/verification/impact.hpp"

#include <array>
#include <cmath>

namespace coupling::verification {
namespace {

char const* const johnson = "Johnson, Contact Mechanics (1985), eqs 4.23, 11.24";

/// Elastic impact of two unequal grains: duration, deepest overlap and largest force.
std::vector<Benchmark> elastic_pair(std::string const& name, dem::Precision precision,
                                    double tolerance) {
  ImpactSetup const setup{.recipe = smooth(1.0, precision),
                          .radius = 0.5e-3,
                          .other_radius = 1.5e-3,
                          .velocity = dem::Vec3(0, 0, -0.5),
                          .other_velocity = dem::Vec3(0, 0, 0.1)};
  HertzImpact const exact = setup.expected();
  ImpactResult const found = collide(setup);
  return {
      compare(name + "/duration", exact.duration(), found.duration, tolerance, johnson),
      compare(name + "/max_overlap", exact.max_overlap(), found.max_overlap, tolerance, johnson),
      compare(name + "/max_force", exact.max_force(), found.max_force, tolerance, johnson),
      compare(name + "/separation_speed", exact.speed, found.separation_speed, tolerance,
              "conservation of energy")};
}

/// A steel ball of 5 mm meets a half-space of steel, and a rigid one, at 0.1 m/s.
std::vector<Benchmark> ball_on_half_space() {
  struct Row {
    char const* name;
    double wall_modulus, depth, force, duration; // [Pa], [m], [N], [s]
  };
  std::vector<Benchmark> rows;
  for (auto const& [name, wall_modulus, depth, force, duration] :
       {Row{"steel", 200e9, 1.897e-6, 27.08, 55.85e-6},
        Row{"rigid", 200e18, 1.438e-6, 35.73, 42.32e-6}}) {
    ImpactSetup setup{.recipe = smooth(), .radius = 5e-3, .velocity = dem::Vec3(0, 0, -0.1)};
    setup.recipe.grain = {"steel", 7850.0, 200e9, 0.3};
    setup.recipe.wall = {"half-space", 7850.0, wall_modulus, 0.3};
    ImpactResult const found = collide(setup);
    std::string const row = std::string("half_space/") + name;
    // The references have four digits.
    rows.push_back(compare(row + "/max_overlap", depth, found.max_overlap, 5e-4, johnson));
    rows.push_back(compare(row + "/max_force", force, found.max_force, 5e-4, johnson));
    rows.push_back(compare(row + "/duration", duration, found.duration, 5e-4, johnson));
  }
  return rows;
}

/// A rigid ball of 10 mm pressed into a half-space of 200 GPa with 1 kN: the engine's force at the
/// depth that Hertz gives.
std::vector<Benchmark> indentation() {
  Recipe recipe = smooth();
  recipe.grain = {"rigid", 7850.0, 200e18, 0.3};
  recipe.wall = {"half-space", 7850.0, 200e9, 0.3};
  constexpr double radius = 10e-3, depth = 10.52e-6; // [m]
  dem::World world = empty_world(recipe);
  world.grains.add({0.0, 0.0, radius - depth}, radius, recipe.grain.density, 0);
  add_tool(world, "plate", plate(50.0 * radius, 10.0 * radius));
  dem::prepare(world);
  // The depth has four digits.
  return {compare("indentation/force", 1000.0, world.grains.force[0].z(), 1e-3, johnson)};
}

/// Restitution realised by velocity Verlet at three steps: an alumina grain of 0.25 mm meets a
/// magnesia grain of 1.5 mm at 0.2 m/s from 1 um away. The deviation from 0.5 is the integrator's,
/// and belongs to the step.
std::vector<Benchmark> restitution_at_step() {
  struct Row {
    char const* name;
    double step, restitution;
  };
  std::vector<Benchmark> rows;
  for (auto const& [name, step, restitution] :
       {Row{"4e-7", 4e-7, 0.497961}, Row{"5e-8", 5e-8, 0.499881},
        Row{"6.25e-9", 6.25e-9, 0.499983}}) {
    ImpactSetup setup{.recipe = smooth(0.5),
                      .radius = 0.25e-3,
                      .other_radius = 1.5e-3,
                      .other_mass_factor = 3500.0 / 3000.0,
                      .velocity = dem::Vec3(0, 0, -0.2),
                      .gap = 1e-6,
                      .time_step = step};
    setup.recipe.grain.density = 3000.0;
    // The reference has six digits.
    rows.push_back(compare(std::string("hertz_damping/restitution_at_step_") + name, restitution,
                           collide(setup).separation_speed / 0.2, 2e-6,
                           "LIGGGHTS 3.8.0, dump with 17 digits, same grains and step"));
  }
  return rows;
}

std::vector<Benchmark> hooke() {
  std::vector<Benchmark> rows;
  for (double const e : {0.3, 0.9}) {
    ImpactSetup setup{.recipe = smooth(e),
                      .radius = 0.5e-3,
                      .other_radius = 1.5e-3,
                      .velocity = dem::Vec3(0, 0, -0.2),
                      .steps = 40000};
    setup.recipe.law.normal = "hooke";
    setup.recipe.law.characteristic_velocity = 0.2;
    HertzImpact const impact = setup.expected();
    ImpactResult const found = collide(setup);
    std::string const name = "hooke/e" + std::to_string(e).substr(0, 3);
    double const k = hooke_stiffness(impact.effective_modulus, impact.effective_radius,
                                     impact.effective_mass, 0.2);
    // Touch falls between two steps: an error of first order in the step, 2.5e-5 of the contact.
    rows.push_back(compare(name + "/restitution", e, found.separation_speed / impact.speed, 1e-4,
                           "damped oscillator, exp(-pi z / sqrt(1 - z^2)) = e"));
    rows.push_back(compare(name + "/duration", hooke_duration(k, impact.effective_mass, e),
                           found.duration, 1e-4, "damped oscillator, half a period"));
  }
  return rows;
}

/// Restitution of plastic contacts without a dashpot, from what loading takes and unloading gives.
std::vector<Benchmark> plastic() {
  std::vector<Benchmark> rows;
  ImpactSetup setup{.recipe = smooth(1.0),
                    .radius = 0.5e-3,
                    .other_radius = 1.5e-3,
                    .velocity = dem::Vec3(0, 0, -0.2)};
  HertzImpact const impact = setup.expected();
  setup.recipe.law.normal = "thornton_ning";
  for (double const ratio : {2.0, 20.0}) { // V / V_y
    double const strength =
        impact.yield_pressure_of(impact.speed / ratio); // yields at this part of the speed
    setup.recipe.law.yield_pressure = strength;
    std::string const name = ratio == 2.0 ? "twice" : "20_times";
    ImpactResult const found = collide(setup);
    rows.push_back(compare("plastic/thornton_ning_at_" + name + "_yield",
                           thornton_ning_restitution(1.0 / ratio),
                           found.separation_speed / impact.speed, 2e-5,
                           "Thornton and Ning (1998), the closed form there"));
  }
  setup.recipe.law.normal = "edinburgh";
  setup.recipe.law.plasticity_ratio = 0.6;
  rows.push_back(compare("plastic/edinburgh", edinburgh_restitution(0.6),
                         collide(setup).separation_speed / impact.speed, 2e-5,
                         "integral of the branches of Thakur et al. (2014)"));
  return rows;
}

} // namespace

std::vector<Experiment> collision_experiments() {
  // 4000 steps a contact: velocity Verlet leaves about 1e-6, touch between steps about as much.
  return {{"hertz/full", [] { return elastic_pair("hertz/full", dem::Precision::full, 1e-5); }},
          {"hertz/mixed", [] { return elastic_pair("hertz/mixed", dem::Precision::mixed, 1e-4); }},
          {"half_space", ball_on_half_space},
          {"indentation", indentation},
          {"hertz_damping", restitution_at_step},
          {"hooke", hooke},
          {"plastic", plastic}};
}

} // namespace coupling::verification
