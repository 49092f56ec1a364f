#include "coupling/reduced/pressed_bed.hpp"

#include "dem/vec3.hpp"

#include <cmath>

namespace coupling::reduced {
namespace {

/// The same solid in another bore.
Bed in_bore(Bed const& bed, double bore) {
  double const ratio = bed.bore / bore;
  return {.solid_area = bed.solid_area * ratio * ratio, .bore = bore};
}

BedForces in_yielding_die(PressedBed const& pressed, double height, double smallest_height) {
  auto found = bed_forces(pressed.law, pressed.bed, height, smallest_height);
  for (int round = 0; round < 2 && pressed.die_yield != 0.0; ++round) {
    double const bore = pressed.bed.bore + pressed.die_yield * found.radial_pressure;
    found = bed_forces(pressed.law, in_bore(pressed.bed, bore), height, smallest_height);
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
