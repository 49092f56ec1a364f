#include "tests/diagnosis/grains/laboratory.hpp"

#include "tests/diagnosis/hide/counter_stream.hpp"

#include <algorithm>
#include <cmath>

namespace hidden {
namespace {

/// A machine that follows the grains' heights.
class Machine {
public:
  Machine(Effects const& effects, Scatter const& scatter, double peak)
      : effects_(effects), scatter_(scatter), peak_(peak) {}

  /// Commanded gap where the grains are `at`. The gap sets the time and the time the drift, by a
  /// hundredth of it: substitution. The clock starts with the first moment.
  Moment moment(Pressed const& at, bool closes) {
    double gap = at.height, time = 0.0;
    for (int k = 0; k < 30; ++k) {
      if (has_started_)
        time = closes ? (start_ - gap) / laboratory_speed
                      : turn_time_ + (gap - turn_gap_) / laboratory_speed;
      gap = at.height - scatter_.zero - offset(gap) - drift(time) - frame(at.upper);
    }
    if (!has_started_)
      start_ = gap, has_started_ = true;
    if (closes)
      turn_gap_ = gap, turn_time_ = time;
    return {.time = time,
            .gap = gap,
            .height = at.height,
            .upper = at.upper,
            .lower = at.lower,
            .radial = at.radial};
  }
  double shown(Moment const& at) const {
    double const share = at.upper / peak_;
    return at.upper * (1.0 + effects_[Effect::force_gain] * (1.0 + 0.1 * (share - 0.5))) +
           effects_[Effect::force_offset] * (1.0 + 0.1 * std::exp(-at.time / 200.0)) +
           scatter_.cell_zero;
  }

private:
  double offset(double gap) const {
    return effects_[Effect::gap_offset] * (1.0 + 0.1 * (gap - 8 * mm) / (12 * mm));
  }
  double drift(double time) const {
    constexpr double warm_up = 1800.0;
    return effects_[Effect::thermal_drift] * warm_up * -std::expm1(-time / warm_up);
  }
  double frame(double force) const {
    double const seating = 0.1 * peak_;
    return effects_[Effect::frame_compliance] *
           (force + 0.25 * seating * force / (std::max(force, 0.0) + seating));
  }
  Effects effects_;
  Scatter scatter_;
  bool has_started_ = false;
  double peak_, start_ = 0.0, turn_gap_ = 0.0, turn_time_ = 0.0;
};

/// First-order stage, exact for a straight line between moments.
void delay(double constant, std::vector<Moment>& moments) {
  double shown = moments.front().upper, before = shown;
  for (std::size_t k = 1; k < moments.size(); ++k) {
    double const dt = moments[k].time - moments[k - 1].time;
    if (!(dt > 0.0)) // a stretched frame may stand still for a moment
      continue;
    double const now = moments[k].upper, slope = (now - before) / dt;
    shown = now - slope * constant + (shown - before + slope * constant) * std::exp(-dt / constant);
    before = now;
    moments[k].upper = shown;
  }
}

/// Linear between the moments around t; `from` moves on.
Moment moment_at(std::vector<Moment> const& all, double t, std::size_t& from) {
  while (from + 2 < all.size() && all[from + 1].time < t)
    ++from;
  auto const &a = all[from], &b = all[from + 1];
  double const share = std::clamp((t - a.time) / std::max(b.time - a.time, 1e-12), 0.0, 1.0);
  auto const mean = [&](double x, double y) { return x + share * (y - x); };
  return {.time = t,
          .gap = mean(a.gap, b.gap),
          .height = mean(a.height, b.height),
          .upper = mean(a.upper, b.upper),
          .lower = mean(a.lower, b.lower),
          .radial = mean(a.radial, b.radial)};
}

} // namespace

std::vector<Moment> seen_by_machine(Curve const& curve, Effects const& effects,
                                    Scatter const& scatter) {
  Machine machine(effects, scatter, curve.peak());
  std::vector<Moment> moments;
  for (auto const& at : curve.loading)
    moments.push_back(machine.moment(at, true));
  for (std::size_t k = 1; k < curve.unloading.size(); ++k)
    moments.push_back(machine.moment(curve.unloading[k], false));
  // Noise of the grains can turn a soft frame's gap back by less than a micrometre.
  std::ranges::stable_sort(moments, {}, &Moment::time);
  for (auto& at : moments)
    at.upper = machine.shown(at);
  double const lag = effects[Effect::force_lag];
  for (int stage = 0; stage < 2 && lag > 0.0; ++stage)
    delay(0.5 * lag, moments);
  return moments;
}

Readings read_moments(std::vector<Moment> const& moments, double compact_height,
                      Gauges const& gauges, std::uint64_t seed) {
  CounterStream clock(seed, Purpose::clock), noise(seed, Purpose::noise);
  auto const read = [&](Sensor const& sensor, double y) {
    return y + sensor.at(y) * noise.normal();
  };
  double const interval = clock.uniform(0.25, 0.5), end = moments.back().time;
  Readings result{};
  std::size_t place = 0;
  for (double t = interval * clock.uniform(); t < end; t += interval * clock.uniform(0.6, 1.4)) {
    auto const at = moment_at(moments, t, place);
    result.time.push_back(t);
    result.gap.push_back(read(gauges.gap, at.gap));
    result.upper.push_back(read(gauges.force, at.upper));
    result.lower.push_back(read(gauges.force, at.lower));
    result.radial.push_back(read(gauges.pressure, at.radial));
  }
  result.compact_height = compact_height + gauges.height_sd * noise.normal();
  return result;
}

} // namespace hidden
