#pragma once

#include "coupling/diagnosis/observations.hpp"

#include <cstdint>

namespace coupling::diagnosis {

/// Rows of a run as a simulation foretells them.
struct HeldOutPrediction {
  Eigen::VectorXd value;      ///< f + b, [n_rows]
  Eigen::MatrixXd covariance; ///< Sigma at it, n_rows x n_rows
};

/// A run that was used neither to calibrate nor to name.
struct HeldOutRun {
  std::string run;
  Eigen::VectorXd measured;          ///< [n_rows]
  std::vector<std::string> channels; ///< of each row
  HeldOutPrediction before, after;   ///< by the calibrated baseline, and by the extended model
};

/// One channel over all held-out runs.
struct ChannelGain {
  std::string channel;  ///< "all": every row over its standard deviation before
  double before, after; ///< r.m.s. errors [unit of the channel; 1 for "all"]
  double ratio;         ///< after / before
  double low, high;     ///< 95 % of the ratio; NaN with fewer than three runs
  double coverage;      ///< share of rows inside value +- 1.96 sd, after
};

struct Gain {
  std::vector<ChannelGain> channels; ///< in the order of their first rows, then "all"
  double elpd_difference; ///< sum over runs of ln N(measured | after) - ln N(measured | before)
  /// What it would scatter by were these runs pressed again and nothing wrong with the model
  /// before: a gain far beyond that is no chance. sqrt(n var) of the runs where there are three and
  /// that is larger. (Two runs do not tell how runs scatter: one presses further, the other
  /// faster.)
  double elpd_error;
};

struct GainSettings {
  int n_draws = 1000; ///< resamplings of the runs
  std::uint64_t seed = 1;
};

/// What an extension is worth on runs that it has never seen. Rows of one run foretell each
/// other. Called a second time with the best wrong cause in the place of `after` it
/// gives the placebo. Interval: percentiles of a bootstrap over runs (Efron 1979).
/// Source of the score: Vehtari, Gelman, Gabry, Stat. Comput. 27 (2017) 1413.
/// @throws dem::InvalidInput without a run, for sizes that differ, values that are no numbers, a
/// covariance that is not positive definite
Gain measure_gain(std::vector<HeldOutRun> const& runs, GainSettings const& settings = {});

} // namespace coupling::diagnosis
