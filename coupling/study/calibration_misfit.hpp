#pragma once

#include "coupling/study/box_minimum.hpp"
#include "coupling/study/calibration.hpp"

namespace coupling::study {

/// A target's residual (y(x) - t) / s(x) and its slope, at a point of all factors in coded units.
struct TargetResidual {
  double value;
  double combined_sd;
  Eigen::VectorXd slope; ///< [n_factors]
};

TargetResidual residual_of(CalibrationTarget const& target, SurfaceSpread spread,
                           Eigen::VectorXd const& coded);

/// Residuals of all targets, or of one.
ResidualsAt residuals_of(CalibrationProblem const& problem);
ResidualsAt residuals_of(CalibrationTarget const& target, SurfaceSpread spread);

/// Bounds of all factors in coded units; held factors have equal ones.
Box box_of(std::vector<CalibrationFactor> const& factors);

Eigen::VectorXd coded_of(std::vector<CalibrationFactor> const& factors,
                         std::vector<double> const& natural);
std::vector<double> natural_of(std::vector<CalibrationFactor> const& factors,
                               Eigen::VectorXd const& coded);

/// @throws dem::InvalidInput
void validate_calibration(CalibrationProblem const& problem);

} // namespace coupling::study
