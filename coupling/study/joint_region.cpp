#include "coupling/study/joint_region.hpp"

#include "coupling/study/box_minimum.hpp"
#include "coupling/study/calibration_misfit.hpp"

#include <algorithm>

namespace coupling::study {
namespace {

using Eigen::VectorXd;

constexpr int nodes_of_two = 161;    // nothing else to minimise: cheap
constexpr int nodes_of_several = 41; // each node is a search
constexpr double margin = 0.06;      // of the region's extent, so that its border lies inside

/// The region's extent with a margin, inside the bounds.
GridAxis frame_of(CalibrationFactor const& factor, CalibratedFactor const& found, int n) {
  double const least = 1e-6 * (factor.highest - factor.lowest);
  double const room = std::max(margin * (found.region_upper - found.region_lower), least);
  return {.low = std::max(factor.lowest, found.region_lower - room),
          .high = std::min(factor.highest, found.region_upper + room),
          .n = n};
}

} // namespace

std::vector<JointRegion> joint_regions(CalibrationProblem const& problem,
                                       Calibration const& found) {
  std::vector<int> free;
  for (int f = 0; f < static_cast<int>(problem.factors.size()); ++f)
    if (!problem.factors[static_cast<std::size_t>(f)].held)
      free.push_back(f);
  std::vector<double> best;
  for (auto const& factor : found.factors)
    best.push_back(factor.value);
  auto const residuals = residuals_of(problem);
  auto const least_at = [&](int a, int b, double x, double y) {
    auto box = box_of(problem.factors);
    auto natural = best;
    natural[static_cast<std::size_t>(a)] = x;
    natural[static_cast<std::size_t>(b)] = y;
    VectorXd point = coded_of(problem.factors, natural);
    if (free.size() == 2)
      return residuals(point).values.squaredNorm();
    for (int const fixed : {a, b})
      box.low[fixed] = box.high[fixed] = point[fixed];
    return minimise_from(residuals, box, point).value;
  };
  int const n = free.size() == 2 ? nodes_of_two : nodes_of_several;
  std::vector<JointRegion> regions;
  for (std::size_t a = 0; a < free.size(); ++a)
    for (std::size_t b = a + 1; b < free.size(); ++b) {
      auto const frame = [&](int f) {
        auto const k = static_cast<std::size_t>(f);
        return frame_of(problem.factors[k], found.factors[k], n);
      };
      regions.push_back({.first = free[a],
                         .second = free[b],
                         .threshold = found.region_threshold,
                         .lines = contour_lines(
                             [&](double x, double y) { return least_at(free[a], free[b], x, y); },
                             frame(free[a]), frame(free[b]), found.region_threshold)});
    }
  return regions;
}

} // namespace coupling::study
