#include "coupling/elastic/tool_stress.hpp"
#include "coupling/press_guards.hpp"
#include "coupling/press_measures.hpp"
#include "coupling/press_tools.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coupling {
namespace {

// Tolerances of the project's acceptance table: 1 % of the peak work, 1 % of the upper punch's
// force.
constexpr double energy_tolerance = 0.01;
constexpr double equilibrium_tolerance = 0.01;
// Momentum is kept to rounding in double precision; single-precision forces lose some 1e-7 of each
// contact's force.
constexpr double momentum_tolerance = 1e-3;

// What breaks turns into fragments and dust, but for the rounding of a sum.
constexpr double mass_tolerance = 1e-10;

Check upper_bound(std::string name, double value, double tolerance) {
  return {
      .name = std::move(name), .value = value, .tolerance = tolerance, .ok = value <= tolerance};
}

/// A ratio whose scale has not come up yet is met by an error of zero only.
double share(double error, double scale) {
  if (error == 0.0)
    return 0.0;
  return scale > 0.0 ? std::abs(error) / scale : std::abs(error);
}

// The frame follows the force in windows; what it lags behind must not matter.
constexpr double frame_tolerance = 0.02;

// Rounding for the transfer; windows of finite length lag behind with their work.
constexpr double transfer_tolerance = 1e-12;
constexpr double interface_tolerance = 1e-3;
constexpr double explicit_limit = 0.3;
constexpr double one_way_limit = 0.05;

void append_coupling_checks(Press const& press, std::vector<Check>& checks) {
  ToolCoupling const& coupling = press.coupling;
  if (coupling.is_rigid())
    return;
  CouplingChecks const& kept = coupling.checks();
  CouplingMode const mode = coupling.choice().mode;
  double gap = 0.0;
  for (std::size_t t = 0; t < coupling.n_tools(); ++t)
    gap = std::max(gap, coupling.tool(t).gap);
  Tooling const& tooling = press.setup.tooling;
  bool const is_drawn = !tooling.die_file.empty() || !tooling.upper_punch_file.empty() ||
                        !tooling.lower_punch_file.empty();
  checks.push_back(
      upper_bound("gap between meshes of tools and what grains touch [m]", gap,
                  is_drawn ? press.setup.elastic.shapes.largest_gap : tooling.chordal_tolerance));
  checks.push_back(upper_bound("transfer, force", kept.force, transfer_tolerance));
  checks.push_back(upper_bound("transfer, moment", kept.moment, transfer_tolerance));
  if (mode == CouplingMode::one_way) {
    // What rigid walls miss of the force is about rho / (1 + rho).
    checks.push_back(upper_bound("one-way, force missed",
                                 kept.coupling_number / (1.0 + kept.coupling_number),
                                 one_way_limit));
    return;
  }
  checks.push_back(upper_bound("transfer, power", kept.power, transfer_tolerance));
  checks.push_back(upper_bound("interface work, error / peak work",
                               share(kept.work_error, energy_scale(press)), interface_tolerance));
  if (mode == CouplingMode::two_way_explicit)
    checks.push_back(
        upper_bound("coupling number of the explicit mode", kept.coupling_number, explicit_limit));
  if (mode == CouplingMode::two_way_implicit)
    checks.push_back(upper_bound("iterations of a window, most",
                                 static_cast<double>(kept.most_iterations),
                                 static_cast<double>(coupling.choice().most_iterations)));
}

double mass_of_grains(Press const& press) {
  auto const& mass = press.world.grains.mass;
  return std::accumulate(mass.begin(), mass.end(), 0.0);
}

std::vector<Check> checks_of(Press const& press) {
  PressTally const& tally = press.tally;
  std::vector<Check> checks{
      upper_bound("energy ledger, error / peak work",
                  share(tally.energy_error, energy_scale(press)), energy_tolerance),
      upper_bound("axial equilibrium at the peak, imbalance / upper punch force",
                  share(tally.imbalance_at_peak, tally.recorded_force), equilibrium_tolerance),
      upper_bound("axial momentum, error / impulse",
                  share(tally.momentum_error, impulse_scale(press)), momentum_tolerance),
      upper_bound("grains outside the tools", tally.max_outside, 0.0),
      upper_bound("largest overlap / smaller radius", tally.max_relative_overlap,
                  press.setup.time_stepping.max_relative_overlap),
      upper_bound("time step / Hertz collision time", tally.step_to_collision,
                  largest_step_to_collision),
      upper_bound("time step / stable step", tally.step_to_stable, 1.0)};
  if (press.setup.breakage.is_on())
    checks.push_back(upper_bound("mass of the grains, error / mass",
                                 share(mass_of_grains(press) - press.grain_mass, press.grain_mass),
                                 mass_tolerance));
  if (!press.setup.frame.is_rigid())
    checks.push_back(upper_bound("press frame, error / largest deflection",
                                 press.programme.frame().largest_error(), frame_tolerance));
  append_coupling_checks(press, checks);
  return checks;
}

} // namespace

Summary summarise(Press const& press) {
  PressTally const& tally = press.tally;
  dem::World const& world = press.world;
  Summary summary;
  summary.max_force = tally.max_force;
  summary.ejection_force = tally.ejection_force;
  summary.porosity = tally.porosity;
  summary.porosity_core = tally.porosity_core;
  summary.compact_height = tally.compact_height;
  summary.springback = (tally.compact_height - tally.smallest_gap) / tally.smallest_gap;
  summary.shape_quality = static_cast<int>(tally.shape_quality);
  summary.shape_similarity = tally.shape_similarity;
  summary.grains = world.grains.size();
  summary.steps = world.step;
  summary.time_step = world.step > 0 ? tally.smallest_step : press.programme.present_step();
  summary.wall_seconds = tally.wall_seconds;
  summary.particle_steps_per_second = static_cast<double>(world.grains.size()) *
                                      static_cast<double>(world.step) /
                                      std::max(tally.wall_seconds, 1e-9);
  summary.mode = press.setup.mode;
  summary.version = PRESSCHECK_VERSION;
  summary.checks = checks_of(press);
  for (std::size_t t = 0; t < world.tools.size(); ++t) {
    ToolSummary rigid;
    rigid.name = world.tools[t].name;
    summary.tools.push_back(press.coupling.is_rigid()
                                ? rigid
                                : tool_stress(press.coupling.tool(t), press.coupling.peak_load(t),
                                              press.setup.elastic.cell_size));
    if (!press.coupling.is_rigid())
      summary.tools.back().contact_share = tool_share(press.setup);
  }
  return summary;
}

} // namespace coupling
