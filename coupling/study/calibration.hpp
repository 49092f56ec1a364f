#pragma once

#include "coupling/study/coding.hpp"
#include "coupling/study/response_surface.hpp"

#include <optional>
#include <string>
#include <vector>

/// Factors for which fitted responses meet measured ones. All in natural units.
namespace coupling::study {

struct CalibrationFactor {
  FactorRange range;          ///< name and coding, as the surfaces were fitted
  double lowest, highest;     ///< bounds, [unit of the factor]
  std::optional<double> held; ///< a factor that is not calibrated stands here
};

struct CalibrationTarget {
  ResponseSurface surface;
  double value; ///< [unit of the response]
  double sd;    ///< standard uncertainty of `value`, >= 0
};

/// What a surface adds to a target's uncertainty.
enum class SurfaceSpread {
  run, ///< that of a new run: how a single simulation meets the target, and a surface that fits
       ///< badly counts little
  mean ///< that of the surface alone: what the mean over all packings would be
};

/// chi^2(x) = sum_j ((y_j(x) - t_j) / s_j(x))^2,  s_j^2 = sd_j^2 + spread of the surface at x.
/// A surface without degrees of freedom for its error adds nothing, and a statement says so.
struct CalibrationProblem {
  std::vector<CalibrationFactor> factors; ///< in the order of the surfaces' columns
  std::vector<CalibrationTarget> targets;
  SurfaceSpread spread = SurfaceSpread::run;
};

struct CalibratedFactor {
  std::string name;
  double value;        ///< where chi^2 is least
  double lower, upper; ///< 95 % profile interval: least chi^2 with this factor fixed <= min + 3.84
  double region_lower, region_upper; ///< the joint 95 % region's extent, min + chi^2_0.95(n_free)
  bool is_held;
  bool is_at_bound;               ///< the least chi^2 lies on a bound: the data want to go further
  bool is_open_low, is_open_high; ///< the interval ends at the bound, not in the data
};

struct CalibratedTarget {
  std::string response;
  double target, target_sd;
  double value;               ///< of the surface at the calibrated factors
  double combined_sd;         ///< s_j there
  double residual;            ///< (value - target) / combined_sd
  double lowest, highest;     ///< of the surface inside the bounds
  bool is_reachable;          ///< target between these
  double residual_alone;      ///< the best that this target alone could do
  std::vector<double> wanted; ///< factors where it would, nearest to the calibrated ones
};

struct Calibration {
  std::vector<CalibratedFactor> factors;
  std::vector<CalibratedTarget> targets;
  double chi_squared;                  ///< the minimum
  int df;                              ///< targets - free factors; the bounds do not count
  double p;                            ///< P(chi^2_df >= minimum); NaN where df is 0 or less
  double region_threshold;             ///< the region holds every point with chi^2 below this
  bool contradicts;                    ///< p < 0.05, or a target out of reach by more than 1.96 sd
  std::vector<std::string> statements; ///< what a reader must know, a sentence each
};

/// @throws dem::InvalidInput for targets and factors that do not fit together, a target without any
/// uncertainty, every factor held, values that are no numbers
/// @throws dem::PhysicsGuard if the search does not come to rest
Calibration calibrate(CalibrationProblem const& problem);

/// chi^2 at a point, e.g. to draw the region.
/// @param natural  one value a factor; held ones as they stand here
double chi_squared(CalibrationProblem const& problem, std::vector<double> const& natural);

/// Values of the one free factor at which a surface meets its target exactly, ascending; none if it
/// does not inside the bounds. With two forces the seed's E = 2250 and 2230 MPa.
struct TargetRoot {
  double value; ///< [unit of the factor]
  double sd;    ///< sqrt(target.sd^2 + sd of the surface's mean ^2) / |dy / dfactor|
};

/// @throws dem::InvalidInput as calibrate(), and if not exactly one factor is free
std::vector<TargetRoot> factor_for_target(std::vector<CalibrationFactor> const& factors,
                                          CalibrationTarget const& target);

} // namespace coupling::study
