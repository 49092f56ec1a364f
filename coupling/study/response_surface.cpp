#include "coupling/study/response_surface.hpp"

#include "coupling/study/distributions.hpp"
#include "coupling/study/estimability.hpp"

#include <cmath>
#include <limits>

namespace coupling::study {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// 0 / 0 is no effect at all.
double ratio_to_error(double value, double error) {
  return value == 0.0 && error == 0.0 ? 0.0 : value / error;
}

} // namespace

ResponseSurface fit_response_surface(Observations data, std::vector<Term> terms) {
  validate_estimable(data, terms);
  auto const& y = data.response;
  auto fit = fit_least_squares(model_matrix(terms, data.coded), y);
  double const largest = y.cwiseAbs().maxCoeff();
  // A constant response leaves the roundings of its mean.
  Eigen::ArrayXd const deviation = y.array() - y.mean();
  bool const varies =
      deviation.abs().maxCoeff() > 64.0 * std::numeric_limits<double>::epsilon() * largest;
  return {.data = std::move(data),
          .terms = std::move(terms),
          .fit = std::move(fit),
          .total_ss = varies ? deviation.square().sum() : 0.0};
}

std::vector<Coefficient> ResponseSurface::coefficients() const {
  double const reach = student_quantile(0.95, fit.residual_df);
  std::vector<Coefficient> all;
  for (Eigen::Index j = 0; j < fit.coefficients.size(); ++j) {
    Term const term = j == 0 ? Term{} : terms[static_cast<std::size_t>(j - 1)];
    double const value = fit.coefficients[j];
    double const error = fit.residual_sd() * std::sqrt(fit.inverse_information(j, j));
    double const t = ratio_to_error(value, error);
    all.push_back({.name = name_of(term, data.factor_names),
                   .group = group_of(term),
                   .value = value,
                   .standard_error = error,
                   .t = t,
                   .p = student_p(t, fit.residual_df),
                   .lower = value - reach * error,
                   .upper = value + reach * error});
  }
  return all;
}

double ResponseSurface::r_squared() const {
  return total_ss > 0.0 ? 1.0 - fit.residual_ss / total_ss : unknown;
}

double ResponseSurface::adjusted_r_squared() const {
  return total_ss > 0.0 ? 1.0 - fit.residual_variance() * (n_runs() - 1) / total_ss : unknown;
}

double ResponseSurface::predicted_r_squared() const {
  return total_ss > 0.0 ? 1.0 - fit.press() / total_ss : unknown;
}

double ResponseSurface::value(Eigen::VectorXd const& coded) const {
  return regressors(terms, coded).dot(fit.coefficients);
}

Eigen::VectorXd ResponseSurface::gradient(Eigen::VectorXd const& coded) const {
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(coded.size());
  for (Eigen::Index f = 0; f < coded.size(); ++f)
    for (std::size_t t = 0; t < terms.size(); ++t)
      slope[f] += fit.coefficients[static_cast<Eigen::Index>(t) + 1] *
                  slope_of(terms[t], coded, static_cast<int>(f));
  return slope;
}

SurfacePrediction ResponseSurface::predict(Eigen::VectorXd const& coded, double confidence) const {
  Eigen::VectorXd const z = regressors(terms, coded);
  double const y = z.dot(fit.coefficients);
  double const spread = z.dot(fit.inverse_information * z);
  double const mean_sd = fit.residual_sd() * std::sqrt(spread);
  double const run_sd = fit.residual_sd() * std::sqrt(1.0 + spread);
  double const reach = student_quantile(confidence, fit.residual_df);
  return {.value = y,
          .mean_sd = mean_sd,
          .run_sd = run_sd,
          .mean_lower = y - reach * mean_sd,
          .mean_upper = y + reach * mean_sd,
          .run_lower = y - reach * run_sd,
          .run_upper = y + reach * run_sd};
}

} // namespace coupling::study
