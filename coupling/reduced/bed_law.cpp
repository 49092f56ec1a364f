#include "coupling/reduced/bed_law.hpp"

#include "dem/expect.hpp"
#include "dem/vec3.hpp"

#include <fmt/format.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace coupling::reduced {
namespace {

constexpr double turn_exponent = 0.25;

double or_one(Table const& factor, double x) {
  return factor.empty() ? 1.0 : factor.at(x);
}

/// Stress of first loading at x beyond the onset, wherever that lies.
double stress_beyond(BedLaw const& law, double x) {
  double whole = law.loading_rest.empty() ? 0.0 : law.stiffness * law.loading_rest.at(x);
  if (x > 0.0) {
    double const stiff = 1.0 + law.stiffening.size * std::pow(x, law.stiffening.exponent);
    whole += law.stiffness * stiff * std::pow(x, law.exponent) - law.cohesion * x;
  }
  double const stress = std::max(whole, 0.0);
  double const excess = std::max(stress - law.yielding.stress, 0.0);
  return stress - law.yielding.size * excess * excess / (excess + law.yielding.stress);
}

/// Of a loose fill's size.
double loose_share(OnsetFill const& fill, double s0) {
  double const x = s0 / fill.decay;
  return fill.tail > 0.0 ? std::pow(1.0 + fill.tail * x, -1.0 / fill.tail) : std::exp(-x);
}

/// Where the onset lies at a stress.
double shifted_onset(BedLaw const& law, double s0) {
  auto const& [size, scale, modulus] = law.onset_crush;
  double const crushed = -std::expm1(-std::pow(s0 / scale, modulus));
  double const faded = law.onset_fines.fade * s0 / (s0 + law.onset_fines.scale);
  return law.onset - law.onset_fill.size * loose_share(law.onset_fill, s0) -
         law.onset_fines.size * (1.0 - faded) + size * crushed;
}

struct Loaded {
  double onset, stress;
};

/// First loading where the onset and the stress that shifts it agree; both to rounding.
Loaded first_loading(BedLaw const& law, double solid_fraction) {
  auto const& [fill, fines, crush] = std::tie(law.onset_fill, law.onset_fines, law.onset_crush);
  if (fill.size == 0.0 && fines.size == 0.0 && crush.size == 0.0)
    return {law.onset, stress_beyond(law, solid_fraction - law.onset)};
  auto const at = [&](double s0) {
    return stress_beyond(law, solid_fraction - shifted_onset(law, s0));
  };
  auto const excess = [&](double s0) { return s0 - at(s0); };
  // No onset lies lower than with all that can lower it.
  double const lowest = law.onset - std::max(fill.size, 0.0) - std::max(fines.size, 0.0) -
                        std::max(-crush.size, 0.0) - std::max(fines.size * -fines.fade, 0.0);
  double const most = stress_beyond(law, solid_fraction - lowest);
  double const least = excess(0.0), largest = excess(most);
  if (least >= 0.0)
    return {shifted_onset(law, 0.0), 0.0};
  if (largest <= 0.0)
    return {shifted_onset(law, most), most};
  std::uintmax_t n_steps = 60;
  auto const [low, high] = boost::math::tools::toms748_solve(
      excess, 0.0, most, least, largest, boost::math::tools::eps_tolerance<double>(50), n_steps);
  double const stress = 0.5 * (low + high);
  return {shifted_onset(law, stress), stress};
}

/// How far an opening has gone: 1 at the turn, 0 where the way to the onset is gone back.
double way_left(BedLaw const& law, double solid_fraction, double most, double onset) {
  if (solid_fraction >= most)
    return 1.0;
  double const way = law.recovery * std::log(most / onset);
  return way > 0.0 ? 1.0 - std::log(most / solid_fraction) / way : 0.0; // before the onset: at once
}

double stress_share(BedLaw const& law, double g) {
  if (g <= 0.0)
    return 0.0;
  return std::pow(law.unloading.empty() ? g : law.unloading.at(g), law.opening);
}

double radial_share(BedLaw const& law, double g) {
  return law.radial_unloading.empty() ? std::sqrt(stress_share(law, g))
                                      : law.radial_unloading.at(g);
}

/// Share of the friction that the wall can give, against the upper punch.
double turned(BedLaw const& law, double opened, double largest_radial) {
  if (opened <= 0.0)
    return 1.0;
  if (law.turn_pressure > 0.0 && largest_radial > 0.0)
    opened *= std::pow(law.turn_pressure / largest_radial, turn_exponent);
  if (law.turn_friction > 0.0 && law.wall_friction > 0.0)
    opened *= law.turn_friction / law.wall_friction;
  return law.wall_turn.empty() ? -1.0 + 2.0 * std::exp(-opened / law.reversal)
                               : law.wall_turn.at(opened);
}

void validate_numbers(BedLaw const& law) {
  auto const refuse = [](char const* name, double value, char const* reason) {
    throw dem::InvalidInput(fmt::format("bed law: {} = {}: {}", name, value, reason));
  };
  if (!(law.stiffness > 0.0))
    refuse("stiffness", law.stiffness, "must be positive. Is it in Pa?");
  if (!(law.cohesion >= 0.0))
    refuse("cohesion", law.cohesion, "must not be negative. Is its sign turned?");
  if (!(law.onset > 0.0 && law.onset < 1.0))
    refuse("onset", law.onset, "is no solid fraction (0 to 1). Is it in percent?");
  if (!(law.exponent >= 1.0))
    refuse("exponent", law.exponent, "must be at least 1. A bed stiffens as it closes?");
  if (!(law.recovery > 0.0 && law.recovery <= largest_recovery))
    refuse("recovery", law.recovery, "must be above 0 and at most 1.5. Is it in percent?");
  if (!(law.opening > 0.0))
    refuse("opening", law.opening, "must be positive. Is its sign turned?");
  if (!(law.wall_friction >= 0.0))
    refuse("wall_friction", law.wall_friction, "must not be negative. Is its sign turned?");
  if (!(law.radial_ratio >= 0.0))
    refuse("radial_ratio", law.radial_ratio, "must not be negative. Is its sign turned?");
  if (!(law.reversal > 0.0))
    refuse("reversal", law.reversal, "must be positive. Is it in metres?");
  if (!(law.free_way >= 0.0 && law.free_way < 1.0))
    refuse("free_way", law.free_way, "is no share of a way (0 to 1). Is it in percent?");
  if (!(law.turn_pressure >= 0.0))
    refuse("turn_pressure", law.turn_pressure, "must not be negative. Is its sign turned?");
  if (!(law.turn_friction >= 0.0))
    refuse("turn_friction", law.turn_friction, "must not be negative. Is its sign turned?");
  if (!(law.onset_fill.decay > 0.0))
    refuse("onset_fill.decay", law.onset_fill.decay, "must be positive. Is it in Pa?");
  if (!(law.onset_fill.tail >= 0.0))
    refuse("onset_fill.tail", law.onset_fill.tail, "must not be negative. Is its sign turned?");
  if (!(law.onset_fines.fade <= 1.0))
    refuse("onset_fines.fade", law.onset_fines.fade, "must be at most 1. No more than all fades?");
  if (!(law.onset_fines.scale > 0.0))
    refuse("onset_fines.scale", law.onset_fines.scale, "must be positive. Is it in Pa?");
  if (!(law.onset_crush.scale > 0.0))
    refuse("onset_crush.scale", law.onset_crush.scale, "must be positive. Is it in Pa?");
  if (!(law.onset_crush.modulus > 0.0))
    refuse("onset_crush.modulus", law.onset_crush.modulus, "must be positive. Is its sign turned?");
  if (!(law.stiffening.exponent > 0.0))
    refuse("stiffening.exponent", law.stiffening.exponent,
           "must be positive. A factor belongs to the stiffness?");
  if (!(law.yielding.stress > 0.0))
    refuse("yielding.stress", law.yielding.stress, "must be positive. Is it in Pa?");
  if (!(law.yielding.size <= 1.0))
    refuse("yielding.size", law.yielding.size, "must be at most 1. No more than all is lost?");
}

} // namespace

double BedLaw::onset_at(double solid_fraction) const {
  return first_loading(*this, solid_fraction).onset;
}

double BedLaw::loading(double solid_fraction) const {
  return first_loading(*this, solid_fraction).stress;
}

double BedLaw::unloading_stress(double solid_fraction, double most) const {
  auto const turn = first_loading(*this, most);
  return turn.stress * stress_share(*this, way_left(*this, solid_fraction, most, turn.onset));
}

void stretch_turn(BedLaw& law, double factor) {
  law.reversal *= factor;
  for (double& knot : law.wall_turn.knots)
    knot *= factor;
}

void validate(BedLaw const& law) {
  validate_numbers(law);
  validate(law.loading_rest, "loading_rest");
  validate(law.unloading, "unloading");
  validate(law.radial_loading, "radial_loading");
  validate(law.radial_unloading, "radial_unloading");
  validate(law.wall_loading, "wall_loading");
  validate(law.wall_turn, "wall_turn");
  VALIDATE(law.loading_rest.empty() || law.loading_rest.values.front() == 0.0,
           "table loading_rest: does not begin at 0 (a bed that is far apart bears nothing). Is it "
           "a factor instead?");
  VALIDATE(law.unloading.empty() ||
               (law.unloading.values.front() == 0.0 && law.unloading.values.back() == 1.0 &&
                law.unloading.knots.front() >= 0.0 && law.unloading.knots.back() == 1.0),
           "table unloading: does not run from a share of 0 to 1 at 1. Is it not a share of the "
           "largest stress?");
}

BedForces bed_forces(BedLaw const& law, Bed const& bed, BedState const& state) {
  auto const turn = first_loading(law, state.most);
  double const beyond = state.most - turn.onset;
  double const g = way_left(law, state.solid_fraction, state.most, turn.onset);
  double const stress = turn.stress * stress_share(law, g);
  double const closed = law.radial_ratio * or_one(law.radial_loading, beyond) * turn.stress;
  double const radial = closed * radial_share(law, g);
  double const area = 0.25 * dem::pi * bed.bore * bed.bore;
  double const mu = law.wall_friction * or_one(law.wall_loading, beyond);
  double const wall =
      turned(law, state.opened, closed) * mu * radial * dem::pi * bed.bore * state.height;
  double const carried = std::clamp(0.5 * wall, -area * stress, area * stress);
  return {.upper = area * stress + carried,
          .lower = area * stress - carried,
          .radial_pressure = radial};
}

BedForces bed_forces(BedLaw const& law, Bed const& bed, double height, double smallest_height) {
  return bed_forces(law, bed,
                    {.height = height,
                     .opened = height - smallest_height,
                     .solid_fraction = bed.solid_area / height,
                     .most = bed.solid_area / std::min(height, smallest_height)});
}

FreeCompact free_compact(BedLaw const& law, Bed const& bed, double smallest_height) {
  double const most = bed.solid_area / smallest_height;
  double const onset = law.onset_at(most);
  if (most <= onset)
    return {.height = smallest_height, .radial_pressure = 0.0};
  double const whole = law.recovery * std::log(most / onset);
  auto const at = [&](double height) {
    return FreeCompact{height, bed_forces(law, bed, height, smallest_height).radial_pressure};
  };
  if (law.free_way > 0.0)
    return at(smallest_height * std::exp((1.0 - law.free_way) * whole));
  double const least = free_share * bed_forces(law, bed, smallest_height, smallest_height).upper;
  double low = smallest_height;
  double high = low * std::exp(whole);
  while (high - low > 1e-10 * high) {
    double const middle = 0.5 * (low + high);
    (bed_forces(law, bed, middle, smallest_height).upper > least ? low : high) = middle;
  }
  return at(high);
}

double way_left_at(BedLaw const& law, Bed const& bed, double height, double smallest_height) {
  double const most = bed.solid_area / smallest_height;
  return way_left(law, bed.solid_area / height, most, law.onset_at(most));
}

} // namespace coupling::reduced
