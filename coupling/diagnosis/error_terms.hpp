#pragma once

#include "coupling/diagnosis/observations.hpp"
#include "coupling/diagnosis/tolerances.hpp"

#include <optional>
#include <string>
#include <vector>

/// The terms of Sigma, one function each. Rows are those of the observations.
namespace coupling::diagnosis {

/// A channel's instrument.
struct ChannelError {
  std::string channel;
  double sd;                ///< of a single reading, >= 0 [unit]
  double sd_relative = 0.0; ///< over |prediction|, added in quadrature
  double correlation = 0.0; ///< between neighbouring rows of a block (a filtered cell), 0 to 1
  bool has_kink = false;    ///< a force or pressure that starts and ends with the contact
  std::optional<double> model_share{}; ///< tau of this channel instead of Tolerances::model_share
};

/// From refinement in time step, mesh, grain number and from packing seeds; empty = none.
struct NumericalError {
  Eigen::VectorXd bias;       ///< finest minus working resolution, [n_rows]
  Eigen::MatrixXd covariance; ///< of a single working run, n_rows x n_rows
};

/// The instrument of each block. @throws dem::InvalidInput if a channel has none, two, or an sd
/// that is negative, or a correlation outside 0 to 1
std::vector<ChannelError> errors_of_blocks(Observations const& observations,
                                           std::vector<ChannelError> const& channels);

/// Sensor:  sd_i sd_k rho^|i - k| / n_repeats inside a block,
///   sd_i^2 = (sd^2 + (sd_relative f_i)^2) / n_readings_i.
Eigen::MatrixXd sensor_covariance(Observations const& observations,
                                  std::vector<ChannelError> const& of_blocks,
                                  Eigen::VectorXd const& predicted);

/// Repeatability:  J diag(sd^2) J' / n_repeats between rows of the same run, 0 between runs.
/// @param changes  J diag(sd), n_rows x n_scatters
Eigen::MatrixXd repeatability_covariance(Observations const& observations,
                                         Eigen::MatrixXd const& changes);

/// Numerical:  covariance + (bias_share b)(bias_share b)'. Source: ASME V&V 20 (2009), u_num.
/// @throws dem::InvalidInput for other numbers of rows
Eigen::MatrixXd numerical_covariance(NumericalError const& numerical, double bias_share,
                                     Eigen::Index n_rows);

/// Matern-3/2:  k(d) = (1 + sqrt(3) d / l) exp(-sqrt(3) d / l). Source: Rasmussen, Williams,
/// Gaussian Processes (2006), eq. 4.17.
double matern_3_2(double distance, double length);

/// A smooth error of given size:  sd_i sd_k k(|s_i - s_k|) c between rows of one channel and phase,
/// c = 1 in the same run and run_correlation between two. The declared tolerance and the slack of
/// a mechanism's form have this shape.
Eigen::MatrixXd smooth_covariance(Observations const& observations, Eigen::VectorXd const& sd,
                                  Tolerances const& tolerances);

/// sd of the declared tolerance, tau |f_i|, [n_rows].
Eigen::VectorXd tolerance_sd(Observations const& observations,
                             std::vector<ChannelError> const& of_blocks,
                             Eigen::VectorXd const& predicted, Tolerances const& tolerances);

/// sd at contact onset and loss, where repeats are not Gaussian:  kink_share F exp(-|f_i| /
/// (kink_decay F)), F = the largest |f| of the channel in that run; 0 for channels without kink.
/// Without it a mechanism that only smears the onset is found everywhere.
Eigen::VectorXd kink_sd(Observations const& observations,
                        std::vector<ChannelError> const& of_blocks,
                        Eigen::VectorXd const& predicted, Tolerances const& tolerances);

} // namespace coupling::diagnosis
