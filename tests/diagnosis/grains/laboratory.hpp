#pragma once

#include "tests/diagnosis/grains/curve.hpp"
#include "tests/diagnosis/hide/press.hpp"
#include "tests/diagnosis/hide/readings.hpp"

namespace hidden {

/// The laboratory's press moves at 1 mm/min both ways, twelve thousand times slower than the
/// grains', which are taken to know no rate: what belongs to a clock (lag, drift) is in laboratory
/// time.
constexpr double laboratory_speed = 1.0 * mm / 60.0; ///< [m/s]

/// Gauges for some kilonewtons: as the full-size press has them, over the ratio of the peaks.
struct Gauges {
  Sensor gap{2e-6, 0.0}, force{1.0, 0.0005}, pressure{6e3, 0.001};
  double height_sd = 15e-6; ///< [m]
};

/// What the machine of one press does beside its effects.
struct Scatter {
  double zero = 0.0;      ///< of the gap [m]
  double cell_zero = 0.0; ///< of the load cell [N]
};

/// The grains' curve as the laboratory's machine sees it: its gap is what it commands,
///   gap = height - zero - offset - drift(t) - frame(F),   |dgap/dt| = 1 mm/min,
/// and its load cell shows the upper force with gain, offset and lag. Forms (F_p: peak):
///   frame   C (F + 0.25 F_s F / (F + F_s)), F_s = 0.1 F_p: seats settle
///   offset  z (1 + 0.1 (gap - 8 mm) / 12 mm)      drift  e T (1 - exp(-t / T)), T = 1800 s
///   gain    F a (1 + 0.1 (F / F_p - 0.5))         cell   o (1 + 0.1 exp(-t / 200 s))
///   lag     two stages of half of it
/// The grains turned at their own height, so the commanded gap at the turn follows; no simulation
/// is needed, and none of the project's machine is used.
/// @return  moments in time's order; `height` is the true one
std::vector<Moment> seen_by_machine(Curve const& curve, Effects const& effects,
                                    Scatter const& scatter);

/// The readings of such a cycle, at uneven times, with noise; the compact's height too.
Readings read_moments(std::vector<Moment> const& moments, double compact_height,
                      Gauges const& gauges, std::uint64_t seed);

} // namespace hidden
