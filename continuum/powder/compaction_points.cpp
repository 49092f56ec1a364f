#include "continuum/powder/compaction_points.hpp"

#include "continuum/expect.hpp"
#include "continuum/tool/quote.hpp"

#include <algorithm>

namespace continuum {

CompactionPoints select_points(std::span<double const> pressure, std::span<double const> density,
                               PressureRange const& range, std::size_t n_parameters,
                               std::string const& name) {
  VALIDATE(pressure.size() == density.size(),
           name + ": " + std::to_string(pressure.size()) + " pressures and " +
               std::to_string(density.size()) + " densities (a point has both). Is a row short?");
  CompactionPoints points{.pressure = {}, .density = {}, .unit = 0.0, .range = {}};
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    if (!(pressure[i] >= range.from && pressure[i] <= range.to))
      continue;
    VALIDATE(density[i] > 0.0 && density[i] < 1.0,
             name + ": relative density = " + quote(density[i]) + " at " + quote(pressure[i]) +
                 " Pa (it lies between 0 and 1). Is it in percent?");
    VALIDATE(pressure[i] >= 0.0, name + ": pressure = " + quote(pressure[i]) +
                                     " Pa (compression is positive). Is its sign turned?");
    points.pressure.push_back(pressure[i]);
    points.density.push_back(density[i]);
  }
  VALIDATE(points.pressure.size() > n_parameters,
           name + ": " + std::to_string(points.pressure.size()) + " points from " +
               quote(range.from) + " to " + quote(range.to) + " Pa for " +
               std::to_string(n_parameters) +
               " parameters (their scatter needs one more). Widen the range?");
  auto const [low, high] = std::ranges::minmax(points.pressure);
  VALIDATE(high > low,
           name + ": all points are at " + quote(low) + " Pa (a curve needs a range). Widen it?");
  points.range = {low, high};
  points.unit = high;
  for (double& P : points.pressure)
    P /= high;
  return points;
}

void validate_initial_density(CompactionPoints const& points, double D_0, std::string const& name) {
  VALIDATE(D_0 > 0.0 && D_0 < std::ranges::max(points.density),
           name + ": initial density = " + quote(D_0) +
               " is not below the densities of the points (pressing densifies). Is it the tapped "
               "density?");
}

} // namespace continuum
