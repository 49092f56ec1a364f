#include "coupling/study/least_squares.hpp"

#include "dem/expect.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <cmath>
#include <limits>

namespace coupling::study {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double decides_alone = 1e-10; // 1 - leverage of a row whose residual is zero by force

} // namespace

LeastSquares fit_least_squares(Eigen::MatrixXd const& X, Eigen::VectorXd const& y) {
  EXPECT(X.rows() == y.size() && X.rows() >= X.cols());
  auto const n = X.rows(), p = X.cols();
  Eigen::HouseholderQR<Eigen::MatrixXd> const qr(X);
  Eigen::MatrixXd const Q = qr.householderQ() * Eigen::MatrixXd::Identity(n, p);
  auto const R = qr.matrixQR().topRows(p).triangularView<Eigen::Upper>();
  Eigen::VectorXd const projected = Q.transpose() * y;
  Eigen::MatrixXd const inverse = R.solve(Eigen::MatrixXd::Identity(p, p));

  LeastSquares fit{.coefficients = R.solve(projected),
                   .inverse_information = inverse * inverse.transpose(),
                   .sequential = projected.array().square(),
                   .residuals = {},
                   .leverage = Q.rowwise().squaredNorm(),
                   .residual_ss = 0.0,
                   .residual_df = static_cast<int>(n - p)};
  double const rounding = 64.0 * std::numeric_limits<double>::epsilon() * y.cwiseAbs().maxCoeff();
  Eigen::VectorXd const rms = (X.array().square().colwise().mean()).sqrt();
  for (Eigen::Index j = 0; j < p; ++j) {
    if (std::abs(fit.coefficients[j]) * rms[j] <= rounding)
      fit.coefficients[j] = 0.0;
    if (std::abs(projected[j]) <= rounding * std::sqrt(static_cast<double>(n)))
      fit.sequential[j] = 0.0;
  }
  fit.residuals = y - X * fit.coefficients;
  if (fit.residuals.cwiseAbs().maxCoeff() <= rounding)
    fit.residuals.setZero();
  fit.residual_ss = fit.residuals.squaredNorm();
  return fit;
}

double LeastSquares::residual_variance() const {
  return residual_df > 0 ? residual_ss / residual_df : unknown;
}

double LeastSquares::residual_sd() const {
  return std::sqrt(residual_variance());
}

Eigen::MatrixXd LeastSquares::covariance() const {
  return residual_variance() * inverse_information;
}

double LeastSquares::press() const {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < residuals.size(); ++i) {
    double const own = 1.0 - leverage[i];
    if (own < decides_alone)
      return unknown;
    sum += std::pow(residuals[i] / own, 2);
  }
  return sum;
}

double LeastSquares::adjusted_ss(std::vector<int> const& columns) const {
  Eigen::VectorXd const b = coefficients(columns);
  Eigen::MatrixXd const block = inverse_information(columns, columns);
  return b.dot(block.llt().solve(b));
}

} // namespace coupling::study
