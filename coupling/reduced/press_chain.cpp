#include "coupling/reduced/press_chain.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace coupling::reduced {
namespace {

/// The moments at which the chain is solved: samples, and the corners of the course between them.
std::vector<double> moments(GapCourse const& course, std::vector<double> const& samples) {
  std::vector<double> all(samples);
  for (double const corner : course.time)
    if (corner < samples.back())
      all.push_back(corner);
  std::ranges::sort(all);
  all.erase(std::ranges::unique(all).begin(), all.end());
  return all;
}

/// h with h = at_rest + D(F_upper(h)). Where F falls as h grows the root lies between at_rest and
/// at_rest + D(F_upper(at_rest)); a compact that hangs on the wall may let F rise for a little.
double meet(PressedBed const& pressed, FrameLaw const& frame, double at_rest, double smallest,
            PressMoment const& moment) {
  if (frame.is_rigid())
    return at_rest;
  auto const departure = [&](double h) {
    double const force = forces(pressed, h, std::min(smallest, h), moment).upper;
    return h - at_rest - frame.deflection(std::max(force, 0.0));
  };
  double const lowest = departure(at_rest);
  if (lowest == 0.0)
    return at_rest;
  double step = -lowest, highest = departure(at_rest + step);
  while (highest < 0.0)
    step *= 2.0, highest = departure(at_rest + step);
  double const high = at_rest + step;
  if (highest == 0.0)
    return high;
  std::uintmax_t most = 200;
  auto const [low, up] =
      boost::math::tools::toms748_solve(departure, at_rest, high, lowest, highest,
                                        boost::math::tools::eps_tolerance<double>(50), most);
  return 0.5 * (low + up);
}

/// How fast the course goes at t: down positive.
double closing_speed(GapCourse const& course, double t) {
  auto const after = std::ranges::lower_bound(course.time, t);
  if (after == course.time.begin() || after == course.time.end())
    return 0.0;
  auto const k = static_cast<std::size_t>(after - course.time.begin());
  return (course.gap[k - 1] - course.gap[k]) / (course.time[k] - course.time[k - 1]);
}

/// Speeds of the whole strokes, which a measured course has without its noise.
class Tempo {
public:
  explicit Tempo(GapCourse const& course) : turning_(turning_of(course)) {
    double const before = turning_.closed - course.time.front();
    double const after = course.time.back() - turning_.opens;
    // Near the turn, where forces are: the last quarter of the closing, the first of the opening.
    double const near = turning_.closed - 0.25 * before, far = turning_.opens + 0.25 * after;
    closing_ = before > 0.0 ? (course.at(near) - turning_.gap) / (turning_.closed - near)
                            : closing_speed(course, turning_.closed);
    opening_ = after > 0.0 ? (course.at(far) - turning_.gap) / (far - turning_.opens) : 0.0;
  }

  PressMoment at(double t, double told) const {
    bool const is_opening = t > turning_.opens;
    return {.closing_speed = closing_,
            .dwelt = std::clamp(t, turning_.closed, turning_.opens) - turning_.closed,
            .opening_speed = is_opening ? opening_ : 0.0,
            .opened = is_opening ? std::max(told - turning_.gap, 0.0) : 0.0};
  }

private:
  Turning turning_;
  double closing_ = 0.0, opening_ = 0.0;
};

double drift_travel(Machine const& machine, double t) {
  double const e = machine.frame.thermal_drift, w = machine.drift_decay;
  return w > 0.0 ? e * -std::expm1(-w * t) / w : e * t;
}

double offset_at(Machine const& machine, double opened) {
  return machine.frame.gap_offset * (1.0 + machine.gap_pitch * opened);
}

/// A cell of two stages: the second lags behind the first.
class TwoStageCell {
public:
  explicit TwoStageCell(Machine const& machine)
      : first_({.lag = (1.0 - machine.second_stage) * machine.load_cell.lag}),
        second_(with_lag(machine.load_cell, machine.second_stage * machine.load_cell.lag)) {}
  double shown(double force, double dt) {
    first_.step_done(force, dt);
    second_.step_done(first_.reading(), dt);
    return second_.reading();
  }

private:
  static LoadCellErrors with_lag(LoadCellErrors errors, double lag) {
    errors.lag = lag;
    return errors;
  }
  LoadCell first_, second_;
};

void validate_cycle(PressedBed const& pressed, GapCourse const& course,
                    std::vector<double> const& samples) {
  validate(pressed.law);
  validate(course);
  VALIDATE(pressed.bed.solid_area > 0.0 && pressed.bed.bore > 0.0,
           fmt::format("bed: {} m of solid in a bore of {} m. Both must be positive?",
                       pressed.bed.solid_area, pressed.bed.bore));
  VALIDATE(std::ranges::adjacent_find(samples, std::greater_equal<>()) == samples.end(),
           "samples: times do not increase. Are two swapped?");
}

} // namespace

std::vector<ChainReading> press_cycle(PressedBed const& pressed, Machine const& machine,
                                      GapCourse const& course, std::vector<double> const& samples) {
  validate_cycle(pressed, course, samples);
  std::vector<ChainReading> readings;
  if (samples.empty())
    return readings;
  TwoStageCell cell(machine);
  Tempo const tempo(course);
  FrameLaw const frame = machine.gap_is_of_faces ? FrameLaw{} : machine.frame;
  double const start = std::min(course.time.front(), samples.front());
  double const turn = turning_of(course).gap;
  double last = start, smallest = course.at(start) + offset_at(machine, course.at(start) - turn);
  std::size_t next = 0;
  for (double const t : moments(course, samples)) {
    double const told = course.at(t);
    double const at_rest =
        told + offset_at(machine, told - turn) + drift_travel(machine, t - start);
    VALIDATE(at_rest > 0.0, fmt::format("gap course: the faces meet at {} s. Is the gap offset "
                                        "({} m) right?",
                                        t, machine.frame.gap_offset));
    auto const moment = tempo.at(t, told);
    double const height = meet(pressed, frame, at_rest, smallest, moment);
    smallest = std::min(smallest, height);
    BedForces const found = forces(pressed, height, smallest, moment);
    double const shown = cell.shown(found.upper, t - last);
    last = t;
    if (t != samples[next])
      continue;
    readings.push_back({t, told, height, found, shown});
    if (++next == samples.size())
      break;
  }
  return readings;
}

double smallest_height(std::vector<ChainReading> const& readings) {
  auto const least = std::ranges::min_element(readings, {}, &ChainReading::height);
  return least->height;
}

} // namespace coupling::reduced
