#pragma once

#include "coupling/study/calibration.hpp"
#include "coupling/study/contour_lines.hpp"

#include <vector>

namespace coupling::study {

/// The border of the joint 95 % region in the plane of two factors: the lines
///   chi^2(x_first, x_second), least over the other free factors, = min chi^2 + chi^2_0.95(n_free),
/// where they lie inside the bounds. For linear surfaces and constant s_j it is the ellipse
///   (x - x0)^T A (x - x0) = chi^2_0.95(n_free),  A = sum_j g_j g_j^T / s_j^2,  g_j = dy_j / dx.
/// Source: Rao, Linear Statistical Inference (1973), 4b.3, for the linear case.
struct JointRegion {
  int first, second;              ///< indices of the factors
  double threshold;               ///< of chi^2
  std::vector<ContourLine> lines; ///< natural units; open where the region reaches a bound
};

/// One for each pair of free factors; none where only one is free (its interval says it).
std::vector<JointRegion> joint_regions(CalibrationProblem const& problem, Calibration const& found);

} // namespace coupling::study
