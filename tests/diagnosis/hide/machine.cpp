#include "tests/diagnosis/hide/machine.hpp"

#include <algorithm>
#include <cmath>

namespace hidden {
namespace {

/// -1 down, 0 at rest, 1 up.
int direction(Protocol const& protocol, double time) {
  return time < protocol.closing_time()                     ? -1
         : time <= protocol.closing_time() + protocol.dwell ? 0
                                                            : 1;
}

/// -0.5 to 0.5, once in `length`.
double saw_tooth(double x, double length) {
  return x / length - std::floor(x / length) - 0.5;
}

/// First-order stage, exact for a straight line between the readings.
void delay(double constant, std::span<Moment> moments) {
  double shown = moments.front().upper, before = shown;
  for (std::size_t k = 1; k < moments.size(); ++k) {
    double const dt = moments[k].time - moments[k - 1].time;
    double const now = moments[k].upper, slope = (now - before) / dt;
    double const kept = std::exp(-dt / constant);
    shown = now - slope * constant + (shown - before + slope * constant) * kept;
    before = now;
    moments[k].upper = shown;
  }
}

} // namespace

double gap_error(Effects const& effects, Protocol const& protocol, double time) {
  constexpr double warm_up = 1800.0;
  double const gap = protocol.gap_at(time);
  return effects[Effect::gap_offset] * (1.0 + 0.1 * (gap - 8 * mm) / (12 * mm)) +
         effects[Effect::thermal_drift] * warm_up * -std::expm1(-time / warm_up);
}

double frame_travel(Effects const& effects, double force) {
  constexpr double seating = 3 * kN;
  return effects[Effect::frame_compliance] *
         (force + 0.25 * seating * force / (std::max(force, 0.0) + seating));
}

double bore_at(Effects const& effects, double height) {
  return stated_bore + effects[Effect::die_size] * (1.0 - 0.3 * std::pow(height / (20 * mm), 2));
}

double rate_factor(Effects const& effects, Protocol const& protocol, double time) {
  constexpr double slowest = 1e-4; // [1/s]
  constexpr double memory = 0.005; // strain that relaxation forgets
  double const height = protocol.gap_at(time);
  double const since = std::clamp(time - protocol.closing_time(), 0.0, protocol.dwell);
  double const down = 1.0 / (height / protocol.speed_down + since / memory);
  double const pressed = std::log1p(down / slowest);
  double const opened = height - protocol.end_gap;
  double const turned = direction(protocol, time) == 1 ? -std::expm1(-opened / (0.1 * mm)) : 0.0;
  double const opening = std::log1p(protocol.speed_up / height / slowest);
  return std::exp(effects[Effect::rate_dependence] * ((1.0 - turned) * pressed - turned * opening));
}

void show_upper_force(Effects const& effects, Protocol const& protocol, std::span<Moment> moments) {
  for (auto& at : moments) {
    double const wall = at.upper - at.lower;
    double force = at.upper;
    force += effects[Effect::stick_slip] * wall * saw_tooth(at.height, 0.15 * mm);
    force -= effects[Effect::guide_friction] * direction(protocol, at.time);
    double const share = force / (30 * kN);
    force *= 1.0 + effects[Effect::force_gain] * (1.0 + 0.1 * (share - 0.5)) +
             effects[Effect::cell_nonlinearity] * share * share;
    force += effects[Effect::force_offset] * (1.0 + 0.1 * std::exp(-at.time / 200.0));
    at.upper = force;
  }
  double const lag = effects[Effect::force_lag];
  for (int stage = 0; stage < 2 && lag > 0.0; ++stage)
    delay(0.5 * lag, moments);
}

} // namespace hidden
