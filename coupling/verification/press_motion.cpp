#include "coupling/case_file.hpp"
#include "coupling/press_measures.hpp"
#include "coupling/press_set_up.hpp"
#include "coupling/verification/benchmarks.hpp"
#include "coupling/verification/closed_forms.hpp"
#include "coupling/verification/setups.hpp"
#include "dem/step/advance.hpp"

#include <algorithm>
#include <cmath>

/// Tools that grains carry or hold back.
namespace coupling::verification {
namespace {

/// A block of mass M falls from rest on four grains that do not move: with linear contacts it
/// oscillates about the overlap d = M g / (4 k) between 0 and 2 d, period 2 pi sqrt(d / g).
/// What the grains leave to the tool's own law of motion is integrated here.
std::vector<Benchmark> block_on_grains() {
  constexpr double radius = 10e-3, rest_overlap = 1e-3, g = 9.81; // [m], [m], [m/s^2]
  constexpr int steps_a_period = 20000, n_periods = 5;
  Recipe recipe = smooth();
  recipe.law.normal = "hooke";
  recipe.law.characteristic_velocity = 0.1;
  double const heavy = 1e20; // [kg/m^3]: the grains stay where they are
  dem::World world = empty_world(recipe);
  for (int corner = 0; corner < 4; ++corner)
    world.grains.add({corner % 2 ? 0.04 : -0.04, corner / 2 ? 0.04 : -0.04, -radius}, radius, heavy,
                     0);
  dem::Tool& block = world.tools[add_tool(world, "block", ceiling(0.05, 0.1))];
  dem::prepare(world);

  double const modulus = effective_modulus(recipe.grain.young_modulus, recipe.grain.poisson_ratio,
                                           recipe.wall.young_modulus, recipe.wall.poisson_ratio);
  double const k = hooke_stiffness(modulus, radius, sphere_mass(heavy, radius),
                                   recipe.law.characteristic_velocity);
  double const mass = 4.0 * k * rest_overlap / g;
  double const period = 2.0 * pi * std::sqrt(rest_overlap / g);
  double const dt = period / steps_a_period;
  double time = 0.0, deepest = 0.0, drift = 0.0, last_bottom = 0.0;
  for (int step = 0; step < n_periods * steps_a_period; ++step) {
    double const before = block.velocity.z();
    block.velocity.z() += 0.5 * dt * (block.force.z() / mass - g);
    dem::advance(world, dt);
    block.velocity.z() += 0.5 * dt * (block.force.z() / mass - g);
    time += dt;
    double const z = block.displacement.z(), v = block.velocity.z();
    if (before < 0.0 && v >= 0.0)
      last_bottom = time - dt * v / (v - before);
    deepest = std::max(deepest, -z);
    double const spring = std::max(-z, 0.0);
    drift =
        std::max(drift, std::abs(0.5 * mass * v * v + mass * g * z + 2.0 * k * spring * spring));
  }
  char const* const source = "linear oscillator, 2 pi sqrt(d/g) about d = M g / (4 k)";
  return {compare("block_on_grains/period", period, last_bottom / (n_periods - 0.5), 1e-6, source),
          compare("block_on_grains/depth", 2.0 * rest_overlap, deepest, 1e-6, source),
          // Of the energy at rest, 1/2 M g d.
          compare("block_on_grains/energy_drift", 0.0, drift / (0.5 * mass * g * rest_overlap),
                  1e-6, "conservation of energy")};
}

/// A steel ball falls on an infinite elastic plate that answers a force F with the velocity
/// alpha F, alpha = 1 / (8 sqrt(D rho h)): waves carry energy away, and the ball comes back with
///   e(lambda),  lambda = alpha m / T,  T = (m / (K sqrt(v)))^(2/5),
/// of  s'' + (1 + lambda d/dt) s^(3/2) = 0.  Zener, Phys. Rev. 59 (1941) 669.
std::vector<Benchmark> ball_on_plate() {
  constexpr double radius = 5e-3, speed = 0.1; // [m], [m/s]
  Recipe recipe = smooth();
  recipe.grain = recipe.wall = {"steel", 7850.0, 200e9, 0.3};
  HertzImpact const hertz{.effective_modulus = effective_modulus(200e9, 0.3, 200e9, 0.3),
                          .effective_radius = radius,
                          .effective_mass = sphere_mass(7850.0, radius),
                          .speed = speed};
  double const mass = hertz.effective_mass;
  double const scale = std::pow(mass / (hertz.stiffness() * std::sqrt(speed)), 0.4);
  double const dt = hertz.duration() / 4000.0;
  std::vector<Benchmark> rows;
  struct Row {
    char const* name;
    double lambda, restitution;
  };
  for (auto const& [name, lambda, restitution] :
       {Row{"0.05", 0.05, 0.9178}, Row{"0.1", 0.1, 0.8433}, Row{"0.2", 0.2, 0.7140},
        Row{"0.3", 0.3, 0.6060}, Row{"0.5", 0.5, 0.4369}, Row{"1", 1.0, 0.1841}}) {
    double const alpha = lambda * scale / mass; // [m/s/N]
    dem::World world = empty_world(recipe);
    world.grains.add({0.0, 0.0, radius}, radius, 7850.0, 0, {0.0, 0.0, -speed});
    dem::Tool& tool = world.tools[add_tool(world, "plate", plate(50.0 * radius, 10.0 * radius))];
    dem::prepare(world);
    do {
      tool.velocity.z() = alpha * tool.force.z();
      dem::advance(world, dt);
    } while (tool.force.z() != 0.0);
    // The references have four digits.
    rows.push_back(compare(std::string("ball_on_plate/restitution_at_") + name, restitution,
                           world.grains.velocity[0].z() / speed, 2e-3,
                           "Zener (1941), integrated with four digits"));
  }
  return rows;
}

/// Means over the second half of a stage.
struct PlugMeans {
  double upper = 0.0, lower = 0.0, pressure = 0.0, height = 0.0;
};

PlugMeans push_plug(double friction) {
  std::string const at = "Press programme/Stage ";
  std::string const entries[] = {"Powder/Total mass=0.3 g",
                                 "Powder/Fill height=8 mm",
                                 "Powder/Component 1/Size classes=1 mm: 60 %, 1.5 mm: 40 %",
                                 "Powder/Component 1/Young's modulus=25 MPa",
                                 "Powder/Component 2/Size classes=1 mm: 100 %",
                                 "Powder/Component 2/Young's modulus=25 MPa",
                                 "Contact/Particle-particle/Cohesion energy density=0 J/m^3",
                                 "Contact/Particle-particle/Coefficient of static friction=0.5",
                                 "Contact/Particle-wall/Coefficient of static friction=" +
                                     std::to_string(friction),
                                 "Tooling/Bore diameter=6 mm",
                                 "Tooling/Die height=12 mm",
                                 "Tooling/Walls=analytic",
                                 at + "1/Speed=-0.4 m/s",
                                 at + "1/Gap=4.4 mm",
                                 at + "2/Tools=upper_punch, lower_punch",
                                 at + "2/Speed=0.1 m/s",
                                 at + "2/Until=time",
                                 at + "2/Duration=20 ms",
                                 at + "3/Kind=none",
                                 at + "4/Kind=none"};
  Press press = set_up_press(parse_case("set Title = Plug\n", "plug", entries));
  PlugMeans sum;
  int n = 0;
  for (; !press.programme.is_done(); press.programme.finish_stage(press.world)) {
    press.programme.start_stage(press.world);
    for (int step = 0; !press.programme.stage_has_ended(press.world); ++step) {
      dem::advance(press.world, press.programme.command_step(press.world));
      press.programme.step_done(press.world);
      bool const is_late = press.programme.stage_progress(press.world) > 0.5;
      if (press.programme.index() == 0 || !is_late || step % 20 != 0)
        continue;
      Reading const now = read_press(press);
      sum.upper += now.upper_punch_force, sum.lower += now.lower_punch_force;
      sum.pressure += now.wall_radial_pressure, sum.height += now.bed_height;
      ++n;
    }
  }
  return {sum.upper / n, sum.lower / n, sum.pressure / n, sum.height / n};
}

/// Both punches push a pressed bed up the die: it slides everywhere, so
///   ln(F_lower / F_upper) = 4 mu K H / D,   K = radial pressure / logarithmic mean axial stress,
/// K as the run has it.  Janssen, Z. Ver. Dtsch. Ing. 39 (1895) 1045.
std::vector<Benchmark> janssen() {
  std::vector<Benchmark> rows;
  constexpr double diameter = 6e-3; // [m]
  for (double const friction : {0.1, 0.2}) {
    PlugMeans const m = push_plug(friction);
    double const area = 0.25 * pi * diameter * diameter;
    double const logarithm = std::log(m.lower / m.upper);
    double const ratio = m.pressure * area * logarithm / (m.lower - m.upper);
    rows.push_back(compare("janssen/mu_" + std::to_string(friction).substr(0, 3),
                           4.0 * friction * ratio * m.height / diameter, logarithm, 0.03,
                           "Janssen (1895), K measured in the run"));
  }
  return rows;
}

} // namespace

std::vector<Experiment> press_motion_experiments() {
  return {
      {"block_on_grains", block_on_grains}, {"ball_on_plate", ball_on_plate}, {"janssen", janssen}};
}

} // namespace coupling::verification
