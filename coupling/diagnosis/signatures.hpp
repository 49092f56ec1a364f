#pragma once

#include "coupling/diagnosis/fit.hpp"
#include "coupling/diagnosis/tangent.hpp"

#include <string>
#include <vector>

namespace coupling::diagnosis {

/// What switching a mechanism on does to all rows, in whitened space and per prior scale of its
/// size. Column 0 has the shape parameters at their means; two more for each of them, one standard
/// deviation below and above.
struct Signature {
  std::string name, unit;
  double scale; ///< s, of the size's prior [unit]
  bool is_one_sided;
  Eigen::MatrixXd whitened;  ///< s L^-1 df/da, n_rows x n_variants
  Eigen::MatrixXd projected; ///< w = P of that, n_extended x n_variants
  double relative_error;     ///< root of the trace of its covariance over its norm, whitened

  double detectability() const { return projected.col(0).norm(); } ///< d per prior scale
  /// The size that stands 5 standard uncertainties out of what calibration absorbs, 5 s / d [unit];
  /// infinite if the data do not see it.
  double smallest_detectable() const;
};

struct SignatureLibrary {
  TangentSpace tangent;
  std::vector<Signature> signatures; ///< in the model's order
  Eigen::VectorXd residual;          ///< P [r ; -u] of the baseline, [n_extended]

  /// w_i' w_j / (d_i d_j), n x n; 0 where one is not seen.
  Eigen::MatrixXd cosines() const;
};

/// Signatures around the fitted baseline.
SignatureLibrary signature_library(Comparison const& comparison, Fit const& baseline);

/// A mechanism's evidence against a projected residual if all is linear: 2 ln of the Bayes factor
/// of a ~ N(0, s^2), half of it if one-sided, against a = 0,
///   (w'r)^2 / (1 + d^2) - ln(1 + d^2)  [+ 2 ln(2 Phi(w'r / sqrt(1 + d^2))) if one-sided],
/// and the size a = s w'r / (1 + d^2) at its top.
struct Score {
  double value; ///< the largest over the variants of the shape
  double size;  ///< [unit of the mechanism], inside its sign
};
Score score_of(Signature const& signature, Eigen::VectorXd const& projected_residual);

} // namespace coupling::diagnosis
