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

/// @param records  of the cycle; @param smallest  height before the first of them [m]
void judge(Departure& upper, Departure& lower, BedLaw const& law, Bed const& bed,
           SimulatedCycle const& cycle, std::vector<std::size_t> const& records, double smallest) {
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
    add(upper, (forces.upper - cycle.upper[k]) / peak);
    add(lower, (forces.lower - cycle.lower[k]) / peak);
    n += 1.0;
  }
  upper.rms = std::sqrt(upper.rms / std::max(n, 1.0));
  lower.rms = std::sqrt(lower.rms / std::max(n, 1.0));
}

} // namespace

BedDepartures departures(BedLaw const& law, SimulatedCycle const& cycle, Bed const& bed) {
  auto const parts = parts_of(cycle);
  BedDepartures found;
  judge(found.loading_upper, found.loading_lower, law, bed, cycle, parts.loading, cycle.height[0]);
  judge(found.unloading_upper, found.unloading_lower, law, bed, cycle, parts.unloading,
        cycle.height[parts.turn]);
  return found;
}

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
  double const turn = cycle.height[parts.turn];
  if (opens && options.shape)
    fit.law.free_way = options.shape->free_way;
  else if (opens)
    fit.law.free_way =
        std::max(way_left_at(fit.law, bed, free_compact(fit.law, bed, turn).height, turn), 0.0);
  validate(fit.law);
  static_cast<BedDepartures&>(fit) = departures(fit.law, cycle, bed);
  if (opens)
    fit.n_unloading = parts.unloading.size();
  else
    fit.unloading_upper = fit.unloading_lower = {};
  return fit;
}

} // namespace coupling::reduced
