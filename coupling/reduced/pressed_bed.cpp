#include "coupling/reduced/pressed_bed.hpp"

#include "dem/vec3.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace coupling::reduced {
namespace {

constexpr int n_rounds = 3;

/// Solid fraction in the bore as wide as a radial pressure makes it.
double solid_fraction(PressedBed const& pressed, double height, double radial_pressure) {
  double const ratio = 1.0 + pressed.die_yield * radial_pressure / pressed.bed.bore;
  return pressed.bed.solid_area / (height * ratio * ratio);
}

/// Where first loading has come to at a height.
BedState loaded_to(PressedBed const& pressed, double height) {
  double const stiff = pressed.bed.solid_area / height;
  BedState turn{.height = height, .opened = 0.0, .solid_fraction = stiff, .most = stiff};
  for (int round = 0; round < n_rounds && pressed.die_yield != 0.0; ++round) {
    auto const found = bed_forces(pressed.law, pressed.bed, turn);
    turn.solid_fraction = turn.most = solid_fraction(pressed, height, found.radial_pressure);
  }
  return turn;
}

BedForces in_yielding_die(PressedBed const& pressed, double height, double smallest_height) {
  auto const& [law, bed] = std::tie(pressed.law, pressed.bed);
  if (pressed.die_yield == 0.0)
    return bed_forces(law, bed, height, smallest_height);
  auto state = loaded_to(pressed, std::min(height, smallest_height));
  auto found = bed_forces(law, bed, state);
  state.height = height;
  state.opened = height - smallest_height;
  // The bore closes as the bed opens, and holds it together.
  for (int round = 0; round < n_rounds && state.opened > 0.0; ++round) {
    double const now = solid_fraction(pressed, height, found.radial_pressure);
    state.solid_fraction = std::min(now, state.most);
    found = bed_forces(law, bed, state);
  }
  return found;
}

} // namespace

double rate_factor(RateLaw const& law, PressMoment const& moment, double height) {
  if (law.gain == 0.0)
    return 1.0;
  auto const term = [&](double rate) { return std::log1p(rate / law.reference); };
  double const closing = moment.closing_speed / height;
  double const left = closing > 0.0 ? 1.0 / (1.0 / closing + moment.dwelt / law.memory) : 0.0;
  double const kept = moment.opening_speed > 0.0 ? std::exp(-moment.opened / law.turning) : 1.0;
  double const turned = term(moment.opening_speed / height);
  return 1.0 + law.gain * (kept * term(left) - (1.0 - kept) * turned);
}

double narrow_height(PressedBed const& pressed, double smallest_height) {
  return pressed.bed.solid_area / loaded_to(pressed, smallest_height).most;
}

BedForces forces(PressedBed const& pressed, double height, double smallest_height,
                 PressMoment const& moment) {
  BedForces sum;
  constexpr int n_strips = 5;
  int const n = pressed.tilt == 0.0 ? 1 : n_strips;
  for (int k = 1; k <= n; ++k) {
    double const angle = k * dem::pi / (n + 1);
    double const weight = n == 1 ? 1.0 : 2.0 / (n + 1) * std::pow(std::sin(angle), 2);
    double const off = n == 1 ? 0.0 : 0.5 * pressed.tilt * std::cos(angle);
    auto const own = in_yielding_die(pressed, height + off, smallest_height + off);
    sum.upper += weight * own.upper;
    sum.lower += weight * own.lower;
    sum.radial_pressure += weight * own.radial_pressure;
  }
  double const factor = rate_factor(pressed.rate, moment, height);
  return {.upper = factor * sum.upper,
          .lower = factor * sum.lower,
          .radial_pressure = factor * sum.radial_pressure};
}

} // namespace coupling::reduced
