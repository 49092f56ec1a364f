#include "coupling/reduced/bed_fit.hpp"

#include "coupling/reduced/loading_fit.hpp"
#include "coupling/reduced/unloading_fit.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::reduced {
namespace {

constexpr double bears = 1e-3; // share of the peak: where neither does, nothing is judged

struct Departures {
  Departure upper, lower;
};

/// @param records  of the cycle; @param smallest  height before the first of them [m]
Departures departures(BedLaw const& law, Bed const& bed, SimulatedCycle const& cycle,
                      std::vector<std::size_t> const& records, double smallest) {
  Departures found;
  double const peak = *std::ranges::max_element(cycle.upper);
  double n = 0.0;
  auto const add = [&](Departure& departure, double missed) {
    departure.rms += missed * missed; // a sum until the end
    departure.largest = std::max(departure.largest, std::abs(missed));
  };
  for (std::size_t const k : records) {
    double const height = cycle.height[k];
    auto const forces = bed_forces(law, bed, height, std::min(smallest, height));
    if (std::max(cycle.upper[k] + cycle.lower[k], forces.upper + forces.lower) < 2.0 * bears * peak)
      continue;
    add(found.upper, (forces.upper - cycle.upper[k]) / peak);
    add(found.lower, (forces.lower - cycle.lower[k]) / peak);
    n += 1.0;
  }
  found.upper.rms = std::sqrt(found.upper.rms / std::max(n, 1.0));
  found.lower.rms = std::sqrt(found.lower.rms / std::max(n, 1.0));
  return found;
}

} // namespace

BedFit fit_bed_law(SimulatedCycle const& cycle, Bed const& bed, BedFitOptions const& options) {
  VALIDATE(bed.solid_area > 0.0 && bed.bore > 0.0,
           fmt::format("bed: {} m of solid in a bore of {} m. Both must be positive?",
                       bed.solid_area, bed.bore));
  auto const parts = parts_of(cycle);
  BedFit fit;
  fit.n_loading = parts.loading.size();
  fit.loading_form = fit_loading(fit.law, rows_of(cycle, bed, parts.loading), options);
  bool const opens = fit_unloading(fit, rows_of(cycle, bed, parts.unloading),
                                   rows_of(cycle, bed, {parts.turn}), options);
  validate(fit.law);
  auto const closing = departures(fit.law, bed, cycle, parts.loading, cycle.height[0]);
  fit.loading_upper = closing.upper, fit.loading_lower = closing.lower;
  if (!opens)
    return fit;
  fit.n_unloading = parts.unloading.size();
  auto const opening = departures(fit.law, bed, cycle, parts.unloading, cycle.height[parts.turn]);
  fit.unloading_upper = opening.upper, fit.unloading_lower = opening.lower;
  return fit;
}

} // namespace coupling::reduced
