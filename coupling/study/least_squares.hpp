#pragma once

#include <Eigen/Core>

#include <vector>

namespace coupling::study {

/// y = X b + e by Householder QR, X = Q R.
struct LeastSquares {
  Eigen::VectorXd coefficients;        ///< b, [n_columns]
  Eigen::MatrixXd inverse_information; ///< (X^T X)^-1 = R^-1 R^-T, n_columns x n_columns
  Eigen::VectorXd sequential; ///< (Q^T y)_j^2: what column j takes from the columns before it
  Eigen::VectorXd residuals;  ///< y - X b, [n_rows]
  Eigen::VectorXd leverage;   ///< diagonal of the hat matrix Q Q^T, [n_rows]
  double residual_ss;         ///< sum of squared residuals
  int residual_df;            ///< n_rows - n_columns

  /// s^2 = residual_ss / residual_df; NaN where no degree of freedom is left.
  double residual_variance() const;
  double residual_sd() const;
  /// s^2 (X^T X)^-1
  Eigen::MatrixXd covariance() const;
  /// Sum of (e_i / (1 - h_i))^2: the squared errors of predicting each row without it. NaN if a row
  /// alone decides a coefficient.  Allen, Technometrics 16 (1974) 125.
  double press() const;
  /// What leaving these columns out would add to residual_ss:  b_g^T [(X^T X)^-1_gg]^-1 b_g.
  double adjusted_ss(std::vector<int> const& columns) const;
};

/// Numbers that rounding makes of zero are zero: coefficients (times their column's root mean
/// square) and residuals below 64 roundings of the largest |y|. Without that a constant response
/// would have significant effects.
/// X must have full column rank (estimability.hpp) and no fewer rows than columns.
LeastSquares fit_least_squares(Eigen::MatrixXd const& X, Eigen::VectorXd const& y);

} // namespace coupling::study
