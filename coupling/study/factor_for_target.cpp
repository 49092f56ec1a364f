#include "coupling/study/calibration.hpp"
#include "coupling/study/calibration_misfit.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace coupling::study {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Roots of a x^2 + b x + c without cancellation; a root that is not there is infinite or NaN.
std::array<double, 2> quadratic_roots(double a, double b, double c) {
  double const q = -0.5 * (b + std::copysign(std::sqrt(b * b - 4.0 * a * c), b));
  return {q / a, c / q};
}

std::size_t free_factor(std::vector<CalibrationFactor> const& factors) {
  auto const is_free = [](CalibrationFactor const& one) { return !one.held; };
  auto const n_free = std::ranges::count_if(factors, is_free);
  VALIDATE(
      n_free == 1,
      fmt::format("factor for a target: {} factors are free (one equation determines one). Hold "
                  "all others?",
                  n_free));
  return static_cast<std::size_t>(std::ranges::find_if(factors, is_free) - factors.begin());
}

} // namespace

std::vector<TargetRoot> factor_for_target(std::vector<CalibrationFactor> const& factors,
                                          CalibrationTarget const& target) {
  // An exact root needs no weights, so an uncertainty of 0 is welcome here.
  CalibrationTarget weighed = target;
  weighed.sd = target.sd == 0.0 ? 1.0 : target.sd;
  validate_calibration({.factors = factors, .targets = {weighed}});
  auto const f = free_factor(factors);
  auto const& range = factors[f].range;
  Box const box = box_of(factors);
  auto const at = [&](double coded) {
    VectorXd x = box.low;
    x[static_cast<Index>(f)] = coded;
    return x;
  };
  auto const& surface = target.surface;
  double const middle = surface.value(at(0.0)), low = surface.value(at(-1.0)),
               high = surface.value(at(1.0));
  std::vector<TargetRoot> roots;
  for (double const coded :
       quadratic_roots(0.5 * (high + low) - middle, 0.5 * (high - low), middle - target.value)) {
    double const natural = range.to_natural(coded);
    if (!(natural >= factors[f].lowest && natural <= factors[f].highest))
      continue;
    double const slope = surface.gradient(at(coded))[static_cast<Index>(f)];
    double const sd = std::hypot(target.sd, surface.predict(at(coded)).mean_sd) / std::abs(slope);
    roots.push_back({natural, sd * 0.5 * (range.high - range.low)});
  }
  std::ranges::sort(roots, {}, &TargetRoot::value);
  return roots;
}

} // namespace coupling::study
