#include "coupling/reduced/simulated_cycle.hpp"

#include "dem/expect.hpp"
#include "dem/vec3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::reduced {
namespace {

constexpr double touches = 1e-3;      // share of the largest force: below it the bed does not bear
constexpr std::size_t least_rise = 8; // records of first loading that bear: two for each number
constexpr double same_height = 1e-9;  // [1]: a dwell moves by no more

double mean_force(SimulatedCycle const& cycle, std::size_t k) {
  return 0.5 * (cycle.upper[k] + cycle.lower[k]);
}

void refuse_unusable(SimulatedCycle const& cycle) {
  std::size_t const n = cycle.height.size();
  VALIDATE(n > 0 && cycle.upper.size() == n && cycle.lower.size() == n &&
               cycle.radial_pressure.size() == n,
           fmt::format("simulated cycle: {} heights, {} and {} forces, {} radial pressures. One of "
                       "each for a record?",
                       n, cycle.upper.size(), cycle.lower.size(), cycle.radial_pressure.size()));
  for (std::size_t k = 0; k < n; ++k) {
    VALIDATE(std::isfinite(cycle.height[k]) && cycle.height[k] > 0.0,
             fmt::format("simulated cycle: record {}: height = {} m: a bed is higher than nothing. "
                         "Is it a travel instead?",
                         k + 1, cycle.height[k]));
    VALIDATE(std::isfinite(cycle.upper[k]) && std::isfinite(cycle.lower[k]) &&
                 std::isfinite(cycle.radial_pressure[k]),
             fmt::format("simulated cycle: record {}: forces {} and {} N, radial pressure {} Pa: "
                         "one is no number. Leave the record out?",
                         k + 1, cycle.upper[k], cycle.lower[k], cycle.radial_pressure[k]));
  }
}

/// Records at which the height is beyond all before, in the sense of `is_beyond`.
template <class IsBeyond>
std::vector<std::size_t> records_beyond(SimulatedCycle const& cycle, std::size_t from,
                                        std::size_t to, IsBeyond is_beyond) {
  std::vector<std::size_t> records;
  double most = cycle.height[from];
  for (std::size_t k = from + 1; k < to; ++k)
    if (is_beyond(cycle.height[k], most)) {
      most = cycle.height[k];
      records.push_back(k);
    }
  return records;
}

} // namespace

SimulatedCycle cycle_of(PressRecord const& record) {
  auto const column = [&](char const* name) {
    VALIDATE(record.has(name), fmt::format("simulated cycle: the record has no column {} (a bed "
                                           "law needs heights, both forces and the radial "
                                           "pressure). Was it a measured curve?",
                                           name));
    return record.column(name);
  };
  return {.height = column("bed_height"),
          .upper = column("upper_punch_force"),
          .lower = column("lower_punch_force"),
          .radial_pressure = column("wall_radial_pressure")};
}

Bed bed_of(Case const& setup) {
  double volume = 0.0;
  for (auto const& component : setup.powder.components)
    volume += setup.powder.total_mass * component.mass_fraction / component.material.density;
  double const bore = setup.tooling.bore_diameter;
  return {.solid_area = volume / (0.25 * dem::pi * bore * bore), .bore = bore};
}

CycleParts parts_of(SimulatedCycle const& cycle) {
  refuse_unusable(cycle);
  CycleParts parts;
  parts.turn =
      static_cast<std::size_t>(std::ranges::min_element(cycle.height) - cycle.height.begin());
  auto const closing = records_beyond(cycle, 0, parts.turn + 1, [](double h, double least) {
    return h < (1.0 - same_height) * least;
  });
  for (std::size_t const k : closing)
    parts.largest_mean = std::max(parts.largest_mean, mean_force(cycle, k));
  VALIDATE(parts.largest_mean > 0.0,
           fmt::format("simulated cycle: no force on the punches down to {} m (the bed was never "
                       "touched). Is the fill lower than the smallest gap?",
                       cycle.height[parts.turn]));
  double const least = touches * parts.largest_mean;
  auto const first = std::ranges::find_if_not(closing.rbegin(), closing.rend(), [&](auto k) {
                       return mean_force(cycle, k) > least;
                     }).base();
  parts.loading.assign(first, closing.end());
  VALIDATE(parts.loading.size() >= least_rise &&
               mean_force(cycle, parts.loading.front()) < 0.5 * parts.largest_mean,
           fmt::format("simulated cycle: the force does not rise over {} records or more up to the "
                       "smallest height, {} m ({} found). Record more often, or press further?",
                       least_rise, cycle.height[parts.turn], parts.loading.size()));
  parts.unloading =
      records_beyond(cycle, parts.turn, cycle.height.size(),
                     [](double h, double most) { return h > (1.0 + same_height) * most; });
  return parts;
}

} // namespace coupling::reduced
