#include "coupling/press_guards.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coupling {
namespace {

[[noreturn]] void stop(dem::World const& world, std::string const& stage,
                       std::string const& evidence) {
  throw dem::PhysicsGuard(fmt::format("stage '{}', t = {:.6g} s, step {}: {}", stage, world.time,
                                      world.step, evidence));
}

} // namespace

double energy_scale(Press const& press) {
  double const weight = press.grain_mass * press.world.gravity.norm();
  return std::max({press.tally.peak_work, std::abs(press.tally.start_energy),
                   weight * press.setup.powder.fill_height});
}

double impulse_scale(Press const& press) {
  double const weight = press.grain_mass * press.world.gravity.norm();
  return std::max(
      {press.tally.throughput, std::abs(press.tally.start_momentum), weight * press.world.time});
}

void guard(Press const& press, Reading const& now) {
  TimeStepping const& limits = press.setup.time_stepping;
  std::string const& stage = press.programme.stage().name;
  auto const columns = curve_columns();
  auto const row = row_of(now);
  for (std::size_t k = 0; k < row.size(); ++k)
    if (!std::isfinite(row[k]))
      stop(press.world, stage,
           fmt::format("{} is not finite. A smaller time step?", columns[k].name));
  if (now.max_relative_overlap > limits.max_relative_overlap)
    stop(press.world, stage,
         fmt::format("an overlap of {:.3g} of the smaller radius exceeds the limit of {:.3g} (the "
                     "contact law means nothing "
                     "there). Stiffer grains, a wider gap, or a larger 'Largest relative overlap'?",
                     now.max_relative_overlap, limits.max_relative_overlap));
  if (now.grains_outside > 0.0)
    stop(press.world, stage,
         fmt::format("{:.0f} grains went through the tools (they are wholly outside). A smaller "
                     "time step, or stiffer "
                     "grains?",
                     now.grains_outside));
  double const scale = std::max(energy_scale(press), std::abs(now.tool_work + now.gravity_work));
  if (std::abs(now.energy_error) > limits.max_energy_error * scale)
    stop(press.world, stage,
         fmt::format("{:.3g} J are not accounted for ({:.3g} of {:.3g} J, limit {:.3g}; an "
                     "unstable step heats). A smaller "
                     "'Rayleigh fraction'?",
                     now.energy_error, std::abs(now.energy_error) / scale, scale,
                     limits.max_energy_error));
}

void guard_step(dem::World const& world) {
  for (dem::Tool const& tool : world.tools)
    if (!std::isfinite(tool.force.squaredNorm()))
      throw dem::PhysicsGuard(
          fmt::format("t = {:.6g} s, step {}: the force on {} is not finite. A smaller time step?",
                      world.time, world.step, tool.name));
}

double step_to_collision_time(Press const& press, double step) {
  dem::World const& world = press.world;
  double fastest = 0.0;
  for (dem::Vec3 const& v : world.grains.velocity)
    fastest = std::max(fastest, v.norm());
  double tool_speed = 0.0;
  for (dem::Tool const& tool : world.tools)
    tool_speed = std::max(tool_speed, tool.velocity.norm());
  double const v = std::max(2.0 * fastest, fastest + tool_speed);
  if (v == 0.0)
    return 0.0;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < world.grains.size(); ++i) {
    std::uint8_t const row = world.grains.material[i];
    double const E = world.materials.pair(row, row).effective_modulus;
    double const m = world.grains.mass[i];
    shortest = std::min(shortest, m * m / (0.5 * world.grains.radius[i] * E * E * v));
  }
  return step / (2.87 * std::pow(shortest, 0.2));
}

} // namespace coupling
