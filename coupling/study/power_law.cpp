#include "coupling/study/power_law.hpp"

#include "coupling/study/distributions.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace coupling::study {
namespace {

void validate_points(std::vector<double> const& x, std::vector<double> const& y) {
  VALIDATE(
      x.size() == y.size(),
      fmt::format("power law: has {} sizes and {} costs. Is one missing?", x.size(), y.size()));
  for (std::size_t k = 0; k < x.size(); ++k)
    VALIDATE(std::isfinite(x[k]) && std::isfinite(y[k]) && x[k] > 0.0 && y[k] > 0.0,
             fmt::format("power law: point {} = ({:g}, {:g}) (both must be above 0 for their "
                         "logarithms). Leave it out?",
                         k + 1, x[k], y[k]));
  auto const n = std::set<double>(x.begin(), x.end()).size();
  VALIDATE(n >= 2,
           fmt::format("power law: has {} different size{} (an exponent needs two). More runs?", n,
                       n == 1 ? "" : "s"));
}

} // namespace

PowerLaw fit_power_law(std::vector<double> const& x, std::vector<double> const& y) {
  validate_points(x, y);
  auto const n = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixXd X = Eigen::MatrixXd::Ones(n, 2);
  X.col(1) = Eigen::Map<Eigen::ArrayXd const>(x.data(), n).log();
  Eigen::VectorXd const log_y = Eigen::Map<Eigen::ArrayXd const>(y.data(), n).log();
  auto fit = fit_least_squares(X, log_y);
  Eigen::VectorXd const b = fit.coefficients;
  double const log_sd = fit.residual_sd();
  Eigen::VectorXd const reach = student_quantile(0.95, fit.residual_df) * log_sd *
                                fit.inverse_information.diagonal().cwiseSqrt();
  return {.factor = std::exp(b[0]),
          .factor_lower = std::exp(b[0] - reach[0]),
          .factor_upper = std::exp(b[0] + reach[0]),
          .exponent = b[1],
          .exponent_lower = b[1] - reach[1],
          .exponent_upper = b[1] + reach[1],
          .log_sd = log_sd,
          .fit = std::move(fit)};
}

CostPrediction PowerLaw::predict(double x) const {
  VALIDATE(std::isfinite(x) && x > 0.0,
           fmt::format("power law: cost at {:g} (a size is above 0). Which is meant?", x));
  Eigen::Vector2d const z(1.0, std::log(x));
  double const middle = z.dot(fit.coefficients), spread = z.dot(fit.inverse_information * z);
  double const unit = student_quantile(0.95, fit.residual_df) * log_sd;
  double const mean = unit * std::sqrt(spread), run = unit * std::sqrt(1.0 + spread);
  return {.value = std::exp(middle),
          .mean_lower = std::exp(middle - mean),
          .mean_upper = std::exp(middle + mean),
          .run_lower = std::exp(middle - run),
          .run_upper = std::exp(middle + run)};
}

} // namespace coupling::study
