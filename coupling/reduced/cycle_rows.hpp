#pragma once

#include "coupling/reduced/bed_law.hpp"
#include "coupling/reduced/simulated_cycle.hpp"

#include <cstddef>
#include <vector>

namespace coupling::reduced {

/// Records of a cycle as the bed law sees them.
struct CycleRows {
  std::vector<double> height; ///< [m]
  std::vector<double> phi;    ///< solid fraction [1]
  std::vector<double> stress; ///< s, mean of both punches [Pa]
  std::vector<double> wall;   ///< W, what the wall carries [N]
  std::vector<double> grip;   ///< what it would carry with a coefficient of 1, p pi D h [N]
  std::vector<double> radial; ///< p [Pa]

  std::size_t size() const { return phi.size(); }
  double largest_stress() const;
};

CycleRows rows_of(SimulatedCycle const& cycle, Bed const& bed,
                  std::vector<std::size_t> const& records);

} // namespace coupling::reduced
