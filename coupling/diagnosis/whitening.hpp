#pragma once

#include <Eigen/Core>

namespace coupling::diagnosis {

/// The Cholesky factor of a covariance, Sigma + jitter diag(Sigma) = L L', and what it does to
/// rows.
class Whitener {
public:
  /// @param largest_jitter  share of each variance; the least of 0, 1e-14, 1e-13, ... up to it with
  /// which the factor exists is added, and said by jitter()
  /// @throws dem::InvalidInput if Sigma is not symmetric or finite, a variance is not positive, or
  /// no such jitter suffices
  Whitener(Eigen::MatrixXd const& covariance, double largest_jitter);

  Eigen::MatrixXd whiten(Eigen::MatrixXd const& rows) const;   ///< L^-1 x, n x k
  Eigen::MatrixXd unwhiten(Eigen::MatrixXd const& rows) const; ///< L x
  double log_determinant() const;                              ///< ln det(L L')
  double jitter() const { return jitter_; } ///< share of each variance, 0 if none was needed
  Eigen::Index size() const { return lower_.rows(); }

private:
  Eigen::MatrixXd lower_;
  double jitter_ = 0.0;
};

} // namespace coupling::diagnosis
