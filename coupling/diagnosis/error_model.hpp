#pragma once

#include "coupling/diagnosis/error_terms.hpp"
#include "coupling/diagnosis/model.hpp"

namespace coupling::diagnosis {

/// Everything that is said of errors.
struct ErrorSources {
  std::vector<ChannelError> channels;
  NumericalError numerical{};
  Eigen::VectorXd
      null_sizes{}; ///< r.m.s. size that each mechanism takes on clean data; empty = none
  Tolerances tolerances{};
};

/// Standard deviation of every row by term, [n_rows] [rows' units], for reports.
struct ErrorShares {
  Eigen::VectorXd sensor, repeatability, numerical, tolerance, form, kink, signature, null;
};

struct ErrorModel {
  Eigen::MatrixXd covariance; ///< Sigma, n_rows x n_rows
  Eigen::VectorXd bias;       ///< b, to be added to the prediction
  ErrorShares shares;
};

/// Sigma at one point:  y = f + b + e, e ~ N(0, Sigma),
///   Sigma = sensor + repeatability + numerical + tolerance + kink
///         + sum over active j of  form slack of f(at) - f(at without j)  +  a_j^2 Cov(v_j)
///         + sum over all j of  null_j^2 v_j v_j'.
/// It hangs on the point: where a fit moves the contact onset, a repeatability that was frozen
/// elsewhere is zero in the very rows that scatter. So it is computed again when the fit moves.
/// Source: diagnosis note 2a; Kennedy, O'Hagan (2001); Brynjarsdottir, O'Hagan (2014).
/// @param active  mechanisms that are on
/// @throws dem::InvalidInput as the terms do, and for null sizes that are negative or miscounted
ErrorModel error_model(Observations const& observations, Model const& model,
                       ErrorSources const& sources, Parameters const& at,
                       std::vector<int> const& active);

} // namespace coupling::diagnosis
