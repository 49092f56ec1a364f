#pragma once

#include "coupling/study/least_squares.hpp"

#include <vector>

namespace coupling::study {

/// A cost at one size: the median, and intervals that are symmetric in its logarithm.
struct CostPrediction {
  double value;                  ///< a x^b
  double mean_lower, mean_upper; ///< 95 % confidence interval of the curve
  double run_lower, run_upper;   ///< 95 % prediction interval of a run that has not been made
};

/// y = a x^b, fitted as ln y = ln a + b ln x: errors are relative. Of a computing time against
/// grain size or number of grains.
struct PowerLaw {
  double factor;                     ///< a
  double factor_lower, factor_upper; ///< 95 % confidence interval
  double exponent;                   ///< b
  double exponent_lower, exponent_upper;
  double log_sd;    ///< residual standard deviation of ln y; NaN for two points
  LeastSquares fit; ///< of ln y on 1 and ln x

  CostPrediction predict(double x) const;
};

/// @throws dem::InvalidInput for tables that differ in length, values that are not above 0, fewer
/// than two different x
PowerLaw fit_power_law(std::vector<double> const& x, std::vector<double> const& y);

} // namespace coupling::study
