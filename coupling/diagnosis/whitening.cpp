#include "coupling/diagnosis/whitening.hpp"

#include "dem/expect.hpp"

#include <Eigen/Cholesky>
#include <fmt/format.h>

namespace coupling::diagnosis {
namespace {

void validate(Eigen::MatrixXd const& covariance) {
  VALIDATE(covariance.rows() == covariance.cols() && covariance.rows() > 0 &&
               covariance.allFinite(),
           fmt::format("covariance: is {} x {} or holds what is no number. Do all error terms have "
                       "the rows of the data?",
                       covariance.rows(), covariance.cols()));
  Eigen::Index row = 0;
  double const least = covariance.diagonal().minCoeff(&row);
  VALIDATE(least > 0.0, fmt::format("covariance: row {} has the variance {:g} (data without any "
                                    "uncertainty cannot be weighed). What is its sensor's sd?",
                                    row + 1, least));
  VALIDATE(covariance.isApprox(covariance.transpose(), 1e-9),
           "covariance: is not symmetric. Was a cross term given once?");
}

} // namespace

Whitener::Whitener(Eigen::MatrixXd const& covariance, double largest_jitter) {
  validate(covariance);
  // Rows of different units share one matrix: the factor is taken of the correlations.
  Eigen::VectorXd const sd = covariance.diagonal().cwiseSqrt();
  Eigen::MatrixXd scaled =
      sd.cwiseInverse().asDiagonal() * covariance * sd.cwiseInverse().asDiagonal();
  for (double added = 0.0;; added = added == 0.0 ? 1e-14 : 10.0 * added) {
    VALIDATE(added <= largest_jitter * 1.0001,
             fmt::format("covariance: is not positive definite even with {:g} of each variance "
                         "added. Are rows repeated without a sensor's error?",
                         largest_jitter));
    scaled.diagonal().setConstant(1.0 + added);
    Eigen::LLT<Eigen::MatrixXd> const factor(scaled);
    if (factor.info() != Eigen::Success)
      continue;
    lower_ = sd.asDiagonal() * Eigen::MatrixXd(factor.matrixL());
    jitter_ = added;
    return;
  }
}

Eigen::MatrixXd Whitener::whiten(Eigen::MatrixXd const& rows) const {
  return lower_.triangularView<Eigen::Lower>().solve(rows);
}

Eigen::MatrixXd Whitener::unwhiten(Eigen::MatrixXd const& rows) const {
  return lower_.triangularView<Eigen::Lower>() * rows;
}

double Whitener::log_determinant() const {
  return 2.0 * lower_.diagonal().array().log().sum();
}

} // namespace coupling::diagnosis
