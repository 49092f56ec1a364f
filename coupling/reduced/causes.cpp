#include "coupling/reduced/causes.hpp"

#include <algorithm>
#include <cmath>

namespace coupling::reduced {
namespace {

using diagnosis::ShapeParameter;
using diagnosis::SizeTail;
using Eigen::VectorXd;

constexpr double um = 1e-6, mm = 1e-3, kN = 1e3, MPa = 1e6, minute = 60.0;

enum class Sign { both, positive };

Cause cause(char const* name, char const* unit, double scale, Sign sign, Side side,
            void (*apply)(Press&, double, VectorXd const&),
            std::vector<ShapeParameter> shapes = {}) {
  return {.mechanism = {.name = name,
                        .unit = unit,
                        .scale = scale,
                        .tail = SizeTail::student,
                        .is_one_sided = sign == Sign::positive,
                        .low = sign == Sign::positive ? 0.0 : -10.0 * scale,
                        .high = 10.0 * scale,
                        .shapes = std::move(shapes)},
          .apply = apply,
          .side = side};
}

/// Seats of the frame give a s F_s more, in all, over the first F_s of the force.
void frame_compliance(Press& press, double a, VectorXd const& shapes) {
  constexpr double seating_force = 3 * kN;
  auto& frame = press.machine.frame;
  if (a <= 0.0)
    return;
  double const own = frame.is_rigid() ? 0.0 : 1.0 / frame.stiffness;
  frame.stiffness = 1.0 / (own + a);
  frame.seating += shapes[0] * a * seating_force;
  frame.seating_force = seating_force;
}
/// A travel gauge that is wrong at zero is a little wrong in its pitch, too.
void gap_offset(Press& press, double a, VectorXd const& shapes) {
  press.machine.frame.gap_offset += a;
  press.machine.gap_pitch = shapes[0] / (10 * mm);
}
void force_gain(Press& press, double a, VectorXd const&) {
  press.machine.load_cell.gain *= 1.0 + a;
}
void force_offset(Press& press, double a, VectorXd const&) {
  press.machine.load_cell.offset += a;
}
void force_lag(Press& press, double a, VectorXd const& shapes) {
  press.machine.load_cell.lag += a;
  press.machine.second_stage = shapes[0];
}
void thermal_drift(Press& press, double a, VectorXd const& shapes) {
  press.machine.frame.thermal_drift += a;
  press.machine.drift_decay = shapes[0];
}
void mass_error(Press& press, double a, VectorXd const&) {
  press.pressed.bed.solid_area *= 1.0 + a;
}
void die_size(Press& press, double a, VectorXd const&) {
  auto& bed = press.pressed.bed;
  double const ratio = bed.bore / (bed.bore + a);
  bed.solid_area *= ratio * ratio;
  bed.bore += a;
}
void punch_tilt(Press& press, double a, VectorXd const&) {
  press.pressed.tilt += a;
}
/// A search asks for sizes far from any press: a bed that opens on no way, or one beyond its fill,
/// is no law.
void add_recovery(BedLaw& law, double change) {
  law.recovery = std::clamp(law.recovery + change, 0.05, largest_recovery);
}
/// Of the coefficient of friction the bed's column shows a part; a rougher wall holds the bed back
/// as it opens. Slopes: cases/seed-library/grain_effects.json.
void wall_friction(Press& press, double a, VectorXd const&) {
  auto& law = press.pressed.law;
  law.wall_friction = std::max(law.wall_friction + 0.7 * a, 0.0);
  add_recovery(law, 0.6 * a);
}
/// Rougher grains pack looser, lean less on the wall and come back less. Slopes:
/// cases/seed-library/grain_effects.json; the bed's stiffness does not change by more than its
/// standard error, which is the shape parameter's.
void particle_friction(Press& press, double a, VectorXd const& shapes) {
  auto& law = press.pressed.law;
  law.onset -= 0.055 * a;
  law.radial_ratio = std::max(law.radial_ratio - 0.74 * a, 0.05);
  add_recovery(law, -0.16 * a);
  law.stiffness *= std::exp(shapes[0] * a);
}
/// E and the cohesion energy density beyond what their sheets allow, which calibration takes up: as
/// PressModel does.
void young_modulus(Press& press, double a, VectorXd const&) {
  press.pressed.law.stiffness *= 1.0 + a;
  press.pressed.law.cohesion *= 1.0 + a;
}
void cohesion(Press& press, double a, VectorXd const&) {
  auto& softening = press.pressed.law.cohesion;
  softening = std::max(softening + cohesion_slope * press.cohesion_density * a, 0.0);
}
/// Contacts that yield: softer above a stress, less given back, and that on a straighter way.
void plastic_contacts(Press& press, double a, VectorXd const& shapes) {
  auto& law = press.pressed.law;
  law.yielding = {.size = 0.3 * a, .stress = shapes[0] * MPa};
  law.recovery *= std::max(1.0 - shapes[1] * a, 0.05);
  law.opening *= std::exp(-shapes[2] * a);
}
void breakage(Press& press, double a, VectorXd const& shapes) {
  auto& law = press.pressed.law;
  law.onset_crush = {.size = a, .scale = shapes[0] * MPa, .modulus = shapes[1]};
}
void rate_dependence(Press& press, double a, VectorXd const& shapes) {
  press.pressed.rate.gain += a;
  press.pressed.rate.memory = shapes[0];
}
void missing_fines(Press& press, double a, VectorXd const& shapes) {
  press.pressed.law.onset_fines = {.size = a, .fade = shapes[0]};
}
void fill_state(Press& press, double a, VectorXd const& shapes) {
  auto& law = press.pressed.law;
  law.onset_fill = {.size = a, .decay = shapes[0] * MPa, .tail = shapes[1]};
}
void die_compliance(Press& press, double a, VectorXd const&) {
  press.pressed.die_yield += a;
}
void multi_contact(Press& press, double a, VectorXd const& shapes) {
  auto& law = press.pressed.law;
  // a is the share at 0.25 beyond the onset, where tablets of this kind end.
  law.stiffening = {.size = 0.3 * a / std::pow(0.25, shapes[0]), .exponent = shapes[0]};
}

/// A share of something that stays above 0.
Cause share(Cause of) {
  of.mechanism.low = -0.95;
  return of;
}

} // namespace

std::vector<Cause> const& known_causes() {
  using enum Sign;
  using enum Side;
  static std::vector<Cause> const all = {
      cause("frame_compliance", "m/N", 20 * um / kN, positive, machine, frame_compliance,
            {{"seating_share", "1", 0.15, 0.15, 0.0, 1.0}}),
      cause("gap_offset", "m", 0.1 * mm, both, machine, gap_offset,
            {{"pitch", "1", 0.0, 0.1, -0.5, 0.5}}),
      cause("force_gain", "1", 0.04, both, machine, force_gain),
      cause("force_offset", "N", 100.0, both, machine, force_offset),
      cause("force_lag", "s", 1.5, positive, machine, force_lag,
            {{"second_stage", "1", 0.25, 0.2, 0.0, 0.5}}),
      cause("thermal_drift", "m/s", 10 * um / minute, both, machine, thermal_drift,
            {{"decay", "1/s", 3e-4, 1.5e-4, 0.0, 1e-3}}),
      cause("mass_error", "1", 0.015, both, machine, mass_error),
      cause("die_size", "m", 0.08 * mm, both, machine, die_size),
      cause("punch_tilt", "m", 0.25 * mm, positive, grains, punch_tilt),
      cause("wall_friction", "1", 0.06, both, grains, wall_friction),
      cause("particle_friction", "1", 0.06, both, grains, particle_friction,
            {{"stiffening", "1", 0.0, 0.3, -3.0, 3.0}}),
      share(cause("young_modulus", "1", 0.25, both, grains, young_modulus)),
      share(cause("cohesion", "1", 0.5, both, grains, cohesion)),
      cause("plastic_contacts", "1", 0.3, positive, grains, plastic_contacts,
            {{"yield_stress", "MPa", 20.0, 10.0, 2.0, 200.0},
             {"kept", "1", 0.7, 0.3, 0.0, 2.0},
             {"straighter", "1", 0.3, 0.3, -2.0, 2.0}}),
      cause("breakage", "1", 0.01, positive, grains, breakage,
            {{"crushing_stress", "MPa", 25.0, 15.0, 2.0, 200.0},
             {"weibull_modulus", "1", 2.0, 1.0, 0.7, 8.0}}),
      cause("rate_dependence", "1", 0.02, positive, machine, rate_dependence,
            {{"memory", "1", 4e-3, 3e-3, 2e-4, 5e-2}}),
      cause("missing_fines", "1", 0.008, both, grains, missing_fines,
            {{"fading", "1", 0.3, 0.2, -0.5, 1.0}}),
      cause("fill_state", "1", 0.008, both, grains, fill_state,
            {{"filling_stress", "MPa", 2.0, 1.0, 0.3, 10.0}, {"tail", "1", 0.5, 0.5, 0.0, 2.0}}),
      cause("die_compliance", "m/Pa", 0.5 * um / MPa, positive, machine, die_compliance),
      cause("multi_contact", "1", 0.3, positive, grains, multi_contact,
            {{"power", "1", 3.0, 1.0, 1.0, 8.0}})};
  return all;
}

std::vector<diagnosis::Scatter> scatters_of(RepeatScatter const& scatter) {
  return {{"mass", "1", scatter.mass},
          {"packing", "1", scatter.onset},
          {"wall_friction", "1", scatter.wall_friction},
          {"gap_zero", "m", scatter.gap_zero},
          {"force_zero", "N", scatter.force_zero}};
}

void apply_scatter(Press& press, VectorXd const& departure) {
  press.pressed.bed.solid_area *= 1.0 + departure[0];
  press.pressed.law.onset += departure[1];
  press.pressed.law.wall_friction *= 1.0 + departure[2];
  press.machine.frame.gap_offset += departure[3];
  press.machine.load_cell.offset += departure[4];
}

} // namespace coupling::reduced
