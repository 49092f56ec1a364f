#pragma once

#include <Eigen/Core>

namespace coupling::diagnosis {

/// What calibration can absorb, and what it cannot: P = I - Q Q' from the QR factors of
/// [L^-1 df/du ; I], u in units of the priors. Rows are extended by one entry a calibrated
/// parameter, where the prior stands as a measurement, so that for whitened rows v
///   |P [v ; 0]|^2 = v' (I + J J')^-1 v.
/// Source: diagnosis note 2a; Plumlee (2017) for the discrepancy orthogonal to the derivatives.
class TangentSpace {
public:
  /// @param slopes  J = L^-1 df/du of the calibrated parameters, n_rows x n_calibrated
  explicit TangentSpace(Eigen::MatrixXd const& slopes);

  /// P x for extended rows, (n_rows + n_calibrated) x k.
  Eigen::MatrixXd project_extended(Eigen::MatrixXd const& rows) const;
  /// P [v ; 0] for whitened rows, n_rows x k in, (n_rows + n_calibrated) x k out.
  Eigen::MatrixXd project(Eigen::MatrixXd const& rows) const;

  Eigen::Index n_rows() const { return basis_.rows() - basis_.cols(); }
  Eigen::Index n_extended() const { return basis_.rows(); }

private:
  Eigen::MatrixXd basis_; ///< Q, orthonormal
};

} // namespace coupling::diagnosis
