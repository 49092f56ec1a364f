#include "coupling/press_cycle.hpp"

#include "coupling/breakage.hpp"
#include "coupling/elastic/implicit_window.hpp"
#include "coupling/fill_state.hpp"
#include "coupling/press_guards.hpp"
#include "coupling/press_measures.hpp"
#include "dem/step/advance.hpp"

#include <algorithm>
#include <cmath>

namespace coupling {
namespace {

// A record or snapshot due at k times its interval is taken at the first step that reaches it but
// for rounding.
constexpr double rounding = 1e-9;

// A peak between two records gets its own row once the force has fallen this much below it.
constexpr double peak_resolution = 0.005;

} // namespace

PressCycle::PressCycle(Press& press, RunFolder& folder, Progress& progress,
                       StopRequest stop_is_requested)
    : press_(press), folder_(folder), progress_(progress),
      stop_is_requested_(std::move(stop_is_requested)) {}

RunEnd PressCycle::run(std::string const& last_stage) {
  PressProgramme& programme = press_.programme;
  if (press_.record.size() == 0)
    begin();
  while (!programme.is_done()) {
    std::string const name = programme.stage().name;
    if (!programme.is_started())
      start_stage();
    while (!programme.stage_has_ended(press_.world)) {
      step();
      record_if_due();
      save_if_due();
      if (stop_is_requested_()) {
        keep_clock();
        dem::complete_step(press_.world);
        folder_.write_restart(press_);
        return RunEnd::interrupted;
      }
    }
    finish_stage();
    if (name == last_stage)
      return RunEnd::stage_reached;
  }
  return RunEnd::finished;
}

void PressCycle::begin() {
  press_.tally.start_energy = total_energy(press_.world);
  press_.tally.start_momentum = axial_momentum(press_.world);
  press_.tally.axial_force = axial_force_on_grains(press_);
  press_.tally.smallest_gap = punch_gap(press_.world, press_.programme.faces());
  record();
  if (press_.setup.output.snapshot_interval > 0.0)
    folder_.write_snapshot(press_);
}

void PressCycle::start_stage() {
  dem::World& world = press_.world;
  bool const releases = press_.programme.stage().kind == StageKind::release;
  double const before = releases ? total_energy(world) : 0.0;
  press_.programme.start_stage(world);
  if (!releases)
    return;
  // Forces and contacts must forget the tools before anything is measured.
  dem::prepare(world);
  press_.tally.released_energy += before - total_energy(world);
  press_.tally.axial_force = axial_force_on_grains(press_);
  if (std::ranges::count(press_.programme.stage().tools, "die") > 0)
    measure_released_shape(press_);
}

void PressCycle::step() {
  dem::World& world = press_.world;
  PressTally& tally = press_.tally;
  if (press_.setup.breakage.is_on() && world.step % breakage_interval == 0)
    break_grains(press_);
  if (press_.coupling.wants_course())
    find_course(press_);
  double const dt = press_.programme.command_step(world);
  dem::advance_ahead(world, dt);
  press_.programme.step_done(world);
  press_.coupling.step_done(world, punch_gap(world, press_.programme.faces()), dt);
  keep_peak();
  guard_step(world);

  double const force = squeezing_force(tool_named(world, "upper_punch"));
  press_.load_cell.step_done(force, dt);
  tally.max_force = std::max(tally.max_force, force);
  if (press_.programme.stage().until == Limit::flush)
    tally.ejection_force =
        std::fmax(tally.ejection_force, squeezing_force(tool_named(world, "lower_punch")));
  tally.smallest_gap = std::min(tally.smallest_gap, punch_gap(world, press_.programme.faces()));
  tally.smallest_step = std::min(tally.smallest_step, dt);
  // Velocity Verlet gives the grains the mean of the forces at both ends of the step.
  double const axial = axial_force_on_grains(press_);
  tally.axial_impulse += 0.5 * dt * (tally.axial_force + axial);
  tally.axial_force = axial;
  tally.throughput += dt * std::abs(force);
}

void PressCycle::keep_peak() {
  double const force = press_.coupling.peak_force();
  if (force > press_.peak.force)
    press_.peak.keep(press_.world, force);
}

void PressCycle::record_if_due() {
  PressTally& tally = press_.tally;
  double const force = squeezing_force(tool_named(press_.world, "upper_punch"));
  bool const interval_is_over = press_.world.time >= static_cast<double>(tally.n_records + 1) *
                                                         press_.setup.output.record_interval *
                                                         (1.0 - rounding);
  bool const peak_was_missed = tally.max_force > (1.0 + peak_resolution) * tally.seen_peak &&
                               force < (1.0 - peak_resolution) * tally.max_force;
  if (interval_is_over)
    tally.n_records = static_cast<std::uint64_t>(
        std::floor(press_.world.time / press_.setup.output.record_interval * (1.0 + rounding)));
  if (interval_is_over || peak_was_missed)
    record();
  if (progress_.is_due(press_.programme.run_progress(press_.world)))
    show_progress();
}

void PressCycle::record() {
  PressTally& tally = press_.tally;
  bool const is_there = press_.record.size() > 0 && tally.last_record == press_.world.time &&
                        press_.record.stages().back() == press_.programme.stage().name;
  if (is_there)
    return;
  dem::complete_step(press_.world);
  tally.last_record = press_.world.time;
  tally.seen_peak = tally.max_force;
  Reading const now = read_press(press_);
  guard(press_, now);
  if (now.upper_punch_force > tally.recorded_force) {
    tally.recorded_force = now.upper_punch_force;
    tally.imbalance_at_peak = now.axial_imbalance;
  }
  tally.max_relative_overlap = std::max(tally.max_relative_overlap, now.max_relative_overlap);
  tally.max_outside = std::max(tally.max_outside, now.grains_outside);
  tally.peak_work = std::max(tally.peak_work, std::abs(now.tool_work + now.gravity_work));
  tally.energy_error = std::max(tally.energy_error, std::abs(now.energy_error));
  tally.momentum_error =
      std::max(tally.momentum_error,
               std::abs(axial_momentum(press_.world) - tally.start_momentum - tally.axial_impulse));
  if (std::isfinite(tally.smallest_step))
    tally.step_to_collision = std::max(
        tally.step_to_collision, step_to_collision_time(press_, press_.programme.present_step()));
  press_.record.add_row(press_.programme.stage().name, row_of(now));
}

void PressCycle::save_if_due() {
  double const interval = press_.setup.output.snapshot_interval;
  PressTally& tally = press_.tally;
  if (interval > 0.0 && press_.world.time >= static_cast<double>(tally.n_snapshots + 1) * interval *
                                                 (1.0 - rounding)) {
    tally.n_snapshots =
        static_cast<std::uint64_t>(std::floor(press_.world.time / interval * (1.0 + rounding)));
    dem::complete_step(press_.world);
    folder_.write_snapshot(press_);
  }
  write_stress_if_due();
  auto const seconds = std::chrono::duration<double>(Clock::now() - last_restart_).count();
  if (seconds < press_.setup.output.restart_interval)
    return;
  keep_clock();
  dem::complete_step(press_.world);
  folder_.write_restart(press_);
  folder_.write_curves(press_);
  last_restart_ = Clock::now();
}

void PressCycle::write_stress_if_due() {
  double const interval = press_.setup.elastic.stress_interval;
  double const time = press_.world.time;
  double& last = press_.tally.last_stress;
  if (interval <= 0.0 || !press_.coupling.is_between_windows() || time == last ||
      std::floor(time / interval * (1.0 + rounding)) ==
          std::floor(last / interval * (1.0 + rounding)))
    return;
  last = time;
  folder_.write_tool_stresses(press_);
}

void PressCycle::finish_stage() {
  PressProgramme& programme = press_.programme;
  press_.coupling.end_window(press_.world);
  keep_peak();
  dem::complete_step(press_.world);
  std::string const name = programme.stage().name;
  bool const is_free = programme.stage().kind == StageKind::free;
  bool const ejects = programme.stage().until == Limit::flush;
  press_.tally.step_to_stable = std::max(
      press_.tally.step_to_stable, programme.present_step() / dem::stable_time_step(press_.world));
  record();
  if (is_free)
    measure_final_shape(press_);
  programme.finish_stage(press_.world);
  if (programme.index() == 1)
    change_materials(press_);
  // The seed's porosity is that of the compact that lies unloaded in its die; a press that ends
  // under load is measured there.
  bool const is_unloaded = squeezing_force(tool_named(press_.world, "upper_punch")) == 0.0;
  if (tool_named(press_.world, "die").present && !ejects && (is_unloaded || programme.is_done()))
    measure_compact(press_);
  if (programme.is_done())
    conclude();
  keep_clock();
  folder_.write_stage_restart(press_, name);
  folder_.write_curves(press_);
}

void PressCycle::conclude() {
  if (press_.setup.output.snapshot_interval > 0.0)
    folder_.write_snapshot(press_);
}

void PressCycle::show_progress() {
  dem::World const& world = press_.world;
  PressProgramme const& programme = press_.programme;
  progress_.show({.stage = programme.stage().name,
                  .stage_fraction = programme.stage_progress(world),
                  .run_fraction = programme.run_progress(world),
                  .time = world.time,
                  .height = programme.commanded_gap(world),
                  .force = squeezing_force(tool_named(world, "upper_punch")),
                  .max_relative_overlap = press_.tally.max_relative_overlap,
                  .step = world.step});
}

void PressCycle::keep_clock() {
  auto const now = Clock::now();
  press_.tally.wall_seconds += std::chrono::duration<double>(now - clock_).count();
  clock_ = now;
}

} // namespace coupling
