#include "coupling/verification/benchmarks.hpp"
#include "coupling/verification/closed_forms.hpp"
#include "coupling/verification/setups.hpp"

#include <cmath>

namespace coupling::verification {
namespace {

/// A plate slides to and fro under a grain that is too heavy to follow, at constant overlap: the
/// force against slip is a spring and Coulomb's plateau, and one cycle dissipates the area of the
/// loop.
std::vector<Benchmark> loop() {
  Recipe recipe;
  recipe.law.cohesion = "none";
  recipe.law.tangential_damping = false;
  recipe.law.precision = dem::Precision::full;
  recipe.grain_wall = {.restitution = 1.0, .static_friction = 0.4};
  double const R = 1e-3, overlap = 2e-5;
  auto const& [g, w] = std::pair(recipe.grain, recipe.wall);
  double const Estar =
      effective_modulus(g.young_modulus, g.poisson_ratio, w.young_modulus, w.poisson_ratio);
  double const Gstar =
      effective_shear_modulus(g.young_modulus, g.poisson_ratio, w.young_modulus, w.poisson_ratio);
  double const limit = 0.4 * 4.0 / 3.0 * Estar * std::sqrt(R * overlap) * overlap;
  double const kt = 8.0 * Gstar * std::sqrt(R * overlap);
  double const slip = limit / kt, amplitude = 4.0 * slip, speed = 1e-2;

  dem::World world = empty_world(recipe);
  world.grains.add(dem::Vec3(0, 0, R - overlap), R, 1e15, 0);
  std::size_t const plate_row = add_tool(world, "plate", plate(20.0 * R, 5.0 * R));
  dem::prepare(world);
  int const quarter = 4000;
  double const dt = amplitude / speed / quarter;
  double area = 0.0, largest = 0.0, first_slope = 0.0;
  dem::Tool& moving = world.tools[plate_row];
  for (int k = 0; k < 5 * quarter; ++k) {
    // + for one quarter from the middle, then - for two, then + for two: the closed cycle is the
    // last four.
    int const leg = (k / quarter + 1) / 2;
    moving.velocity = dem::Vec3(leg % 2 == 0 ? speed : -speed, 0, 0);
    double const before = moving.force.x();
    dem::advance(world, dt);
    largest = std::max(largest, std::abs(moving.force.x()));
    if (k == quarter / 8)
      first_slope = (before - moving.force.x()) / (speed * dt);
    if (k >= quarter)
      area -= 0.5 * (before + moving.force.x()) * moving.velocity.x() * dt;
  }
  char const* const source = "parallelogram of spring k_t = 8 G* sqrt(R* d) and limit mu F";
  // The trapezoid misses the four corners by (one step)^2 each: 1e-6 of the area.
  return {
      compare("mindlin/stiffness", kt, first_slope, 1e-6, source),
      compare("mindlin/limit", limit, largest, 1e-6, source),
      compare("mindlin/loop_area", friction_loop_area(limit, kt, amplitude), area, 1e-4, source)};
}

/// Acceleration along a plane tilted by `angle`, from the speeds at half and full time, and the
/// spin's over it.
struct Descent {
  double acceleration, spin_ratio;
};

Descent descend(double angle, double friction) {
  Recipe recipe;
  recipe.law.cohesion = "none";
  recipe.law.precision = dem::Precision::full;
  recipe.grain_wall = {.restitution = 0.3, .static_friction = friction};
  double const g = 9.81, R = 0.5e-3;
  recipe.gravity = g * dem::Vec3(std::sin(angle), 0, -std::cos(angle));
  auto const& [a, b] = std::pair(recipe.grain, recipe.wall);
  double const K =
      4.0 / 3.0 * std::sqrt(R) *
      effective_modulus(a.young_modulus, a.poisson_ratio, b.young_modulus, b.poisson_ratio);
  double const overlap = std::pow(sphere_mass(a.density, R) * g * std::cos(angle) / K, 2.0 / 3.0);
  dem::World world = empty_world(recipe);
  world.grains.add(dem::Vec3(-20.0 * R, 0, R - overlap), R, a.density, 0);
  add_tool(world, "incline", plate(100.0 * R, 10.0 * R));
  dem::prepare(world);
  double const dt = 2e-6;
  int const half = 10000;
  double speed = 0.0, spin = 0.0;
  for (int k = 0; k < half; ++k)
    dem::advance(world, dt);
  speed = world.grains.velocity[0].x();
  spin = world.grains.spin[0].y();
  for (int k = 0; k < half; ++k)
    dem::advance(world, dt);
  double const acceleration = (world.grains.velocity[0].x() - speed) / (half * dt);
  double const angular = (world.grains.spin[0].y() - spin) / (half * dt);
  return {acceleration, R * angular / acceleration};
}

std::vector<Benchmark> incline() {
  double const mu = 0.3, g = 9.81, threshold = std::atan(3.5 * mu);
  char const* const source = "rigid sphere: rolls with 5/7 g sin a while tan a < 7/2 mu";
  std::vector<Benchmark> rows;
  auto const rolling = [&](std::string const& name, double angle) {
    Descent const found = descend(angle, mu);
    rows.push_back(compare("incline/" + name + "/acceleration", 5.0 / 7.0 * g * std::sin(angle),
                           found.acceleration, 1e-3, source));
    rows.push_back(compare("incline/" + name + "/spin_ratio", 1.0, found.spin_ratio, 1e-3, source));
  };
  auto const sliding = [&](std::string const& name, double angle) {
    Descent const found = descend(angle, mu);
    double const a = g * (std::sin(angle) - mu * std::cos(angle));
    rows.push_back(
        compare("incline/" + name + "/acceleration", a, found.acceleration, 1e-3, source));
    rows.push_back(compare("incline/" + name + "/spin_ratio", 2.5 * mu * g * std::cos(angle) / a,
                           found.spin_ratio, 1e-3, source));
  };
  rolling("rolling_20_degrees", 20.0 * pi / 180.0);
  rolling("rolling_just_below_threshold", 0.98 * threshold);
  sliding("sliding_just_above_threshold", 1.02 * threshold);
  sliding("sliding_70_degrees", 70.0 * pi / 180.0);
  return rows;
}

} // namespace

std::vector<Experiment> friction_experiments() {
  return {{"mindlin", loop}, {"incline", incline}};
}

} // namespace coupling::verification
