#include "tests/diagnosis/hide/extras.hpp"

#include "tests/diagnosis/hide/counter_stream.hpp"
#include "tests/diagnosis/hide/machine.hpp"

#include <algorithm>
#include <array>

namespace hidden {
namespace {

double lowest(Cycle const& cycle) {
  return std::ranges::min_element(cycle.moments, {}, &Moment::height)->height;
}

double mass_of(Effects const& effects, Repeat const& repeat) {
  return stated_mass * (1.0 + repeat.mass) *
         (1.0 + effects[Effect::mass_error] * (1.0 + repeat.mass_error));
}

/// What the cell shows of a weight that hangs on it, warm and long after it was put on.
double shown(Effects const& effects, double weight) {
  std::array<Moment, 2> moments{};
  for (std::size_t k = 0; k < moments.size(); ++k)
    moments[k] = {.time = 1e4 * static_cast<double>(k + 1),
                  .gap = 0.0,
                  .height = 0.0,
                  .upper = weight,
                  .lower = weight,
                  .radial = 0.0};
  // At rest: guides do not rub.
  show_upper_force(effects.with(Effect::guide_friction, 0.0), {}, moments);
  return moments.back().upper;
}

} // namespace

MeasuredNumber measured_number(Case const& of, std::uint64_t run, Cycle const& cycle) {
  auto const effects = of.effects();
  CounterStream noise(of.seed, Purpose::extra, run);
  auto const with = [&](std::string_view name, std::string_view unit, double value, double sd) {
    return MeasuredNumber{name, unit, value + sd * noise.normal(), sd};
  };
  switch (of.extra) {
  case Extra::compact_height:
    return with("compact_height", "m", cycle.compact_height, 20e-6);
  case Extra::compact_mass:
    return with("compact_mass", "kg", mass_of(effects, of.runs[run].repeat), 5e-6);
  case Extra::compact_diameter:
    return with("compact_diameter", "m", bore_at(effects, lowest(cycle)), 5e-6);
  case Extra::gap_at_peak:
    return with("gap_at_peak", "m", lowest(cycle), 5e-6);
  case Extra::dead_weight:
    return with("dead_weight", "N", shown(effects, 10 * kN) + of.runs[run].repeat.cell_zero, 10.0);
  default:
    return {};
  }
}

} // namespace hidden
