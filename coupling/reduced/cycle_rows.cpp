#include "coupling/reduced/cycle_rows.hpp"

#include "dem/vec3.hpp"

#include <algorithm>

namespace coupling::reduced {

double CycleRows::largest_stress() const {
  return stress.empty() ? 0.0 : *std::ranges::max_element(stress);
}

CycleRows rows_of(SimulatedCycle const& cycle, Bed const& bed,
                  std::vector<std::size_t> const& records) {
  double const area = 0.25 * dem::pi * bed.bore * bed.bore;
  CycleRows rows;
  for (std::size_t const k : records) {
    double const height = cycle.height[k], radial = cycle.radial_pressure[k];
    rows.height.push_back(height);
    rows.phi.push_back(bed.solid_area / height);
    rows.stress.push_back(0.5 * (cycle.upper[k] + cycle.lower[k]) / area);
    rows.wall.push_back(cycle.upper[k] - cycle.lower[k]);
    rows.grip.push_back(radial * dem::pi * bed.bore * height);
    rows.radial.push_back(radial);
  }
  return rows;
}

} // namespace coupling::reduced
