#pragma once

#include "continuum/powder/compaction_curve.hpp"

#include <span>
#include <string>
#include <vector>

namespace continuum {

/// The points of a range, pressures in units of the largest.
struct CompactionPoints {
  std::vector<double> pressure, density;
  double unit; ///< [Pa]
  PressureRange range;
};

/// @param name  what messages call the fit
/// @throws InvalidInput for points without a fit
CompactionPoints select_points(std::span<double const> pressure, std::span<double const> density,
                               PressureRange const& range, std::size_t n_parameters,
                               std::string const& name);

/// @throws InvalidInput unless D_0 is positive and below a point's density
void validate_initial_density(CompactionPoints const& points, double D_0, std::string const& name);

} // namespace continuum
