#include "coupling/diagnosis/evidence.hpp"

#include "coupling/diagnosis/normal_draws.hpp"

#include <Eigen/Cholesky>

#include <cmath>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd curvature_of(Unknowns const& unknowns, Fit const& fit) {
  MatrixXd H = fit.slopes.transpose() * fit.slopes;
  // Far out Student's t is convex downwards; the data decide there.
  H.diagonal() += unknowns.prior_curvature(fit.unknowns).cwiseMax(0.0);
  H.diagonal().array() += 1e-12;
  return H;
}

/// ln of twice the share of the local Gaussian at sizes above 0, against all of it.
double log_one_sided(double u, double gradient, double curvature) {
  double const top = u - gradient / curvature; // of the Gaussian, below 0 where the bound holds
  double const above =
      gradient > 0.0 && u <= 0.0
          ? 0.5 * gradient * gradient / curvature + log_normal_cdf(-gradient / std::sqrt(curvature))
          : log_normal_cdf(top * std::sqrt(curvature));
  return std::log(2.0) + above;
}

} // namespace

double log_evidence(Comparison const& comparison, Fit const& fit) {
  Unknowns const unknowns(*comparison.model, fit.active, SizePriors::physical);
  MatrixXd const H = curvature_of(unknowns, fit);
  Eigen::LLT<MatrixXd> const factor(H);
  MatrixXd const covariance = factor.solve(MatrixXd::Identity(H.rows(), H.cols()));
  VectorXd const gradient =
      unknowns.prior_slope(fit.unknowns).cwiseProduct(unknowns.prior_residual(fit.unknowns)) -
      fit.slopes.transpose() * fit.residual;
  double sum = -0.5 * fit.objective() + unknowns.log_prior_height() -
               MatrixXd(factor.matrixL()).diagonal().array().log().sum();
  for (int const j : fit.active) {
    if (!comparison.model->mechanisms()[static_cast<std::size_t>(j)].is_one_sided)
      continue;
    Index const place = unknowns.place_of_size(j);
    // At rest inside, the gradient is the search's rounding and no information.
    double const g = fit.unknowns[place] > 0.0 ? 0.0 : gradient[place];
    sum += log_one_sided(fit.unknowns[place], g, 1.0 / covariance(place, place));
  }
  return sum;
}

VectorXd standard_uncertainties(Comparison const& comparison, Fit const& fit) {
  Unknowns const unknowns(*comparison.model, fit.active, SizePriors::physical);
  MatrixXd const H = curvature_of(unknowns, fit);
  return H.llt().solve(MatrixXd::Identity(H.rows(), H.cols())).diagonal().cwiseSqrt();
}

} // namespace coupling::diagnosis
