#include "coupling/study/size_trend.hpp"

#include "coupling/study/box_minimum.hpp"
#include "coupling/study/distributions.hpp"
#include "coupling/study/least_squares.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace coupling::study {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// d y / d p at a size; exact but for rounding where the form is linear.
VectorXd slopes_of(TrendForm const& form, VectorXd const& parameters, double size) {
  VectorXd slopes(parameters.size());
  for (Index k = 0; k < parameters.size(); ++k) {
    if (form.is_linear) {
      slopes[k] = form.value(VectorXd::Unit(parameters.size(), k), size);
      continue;
    }
    double const h = 1e-6 * (form.high[k] - form.low[k]);
    VectorXd up = parameters, down = parameters;
    up[k] = std::min(up[k] + h, form.high[k]);
    down[k] = std::max(down[k] - h, form.low[k]);
    slopes[k] = (form.value(up, size) - form.value(down, size)) / (up[k] - down[k]);
  }
  return slopes;
}

Eigen::MatrixXd slopes_at(TrendForm const& form, VectorXd const& parameters,
                          VectorXd const& sizes) {
  Eigen::MatrixXd J(sizes.size(), parameters.size());
  for (Index i = 0; i < sizes.size(); ++i)
    J.row(i) = slopes_of(form, parameters, sizes[i]);
  return J;
}

VectorXd values_at(TrendForm const& form, VectorXd const& parameters, VectorXd const& sizes) {
  return sizes.unaryExpr([&](double size) { return form.value(parameters, size); });
}

VectorXd best_parameters(TrendForm const& form, VectorXd const& sizes, VectorXd const& responses) {
  auto const n = static_cast<Index>(form.parameters.size());
  if (form.is_linear)
    return fit_least_squares(slopes_at(form, VectorXd::Zero(n), sizes), responses).coefficients;
  double const scale = responses.cwiseAbs().maxCoeff();
  ResidualsAt const residuals = [&](VectorXd const& p) {
    return Residuals{(values_at(form, p, sizes) - responses) / scale,
                     slopes_at(form, p, sizes) / scale};
  };
  return minimise_in(residuals, {form.low, form.high}).x;
}

double corrected_aic(double rss, int n, int n_parameters) {
  int const k = n_parameters + 1; // and the variance
  if (n - k - 1 <= 0 || rss == 0.0)
    return unknown;
  return n * std::log(rss / n) + 2.0 * k + 2.0 * k * (k + 1.0) / (n - k - 1.0);
}

TrendFit fit_form(TrendForm const& form, VectorXd const& sizes, VectorXd const& responses,
                  double size) {
  VectorXd const p = best_parameters(form, sizes, responses);
  VectorXd const missing = responses - values_at(form, p, sizes);
  // Around the best parameters the form is linear; what is left to fit is rounding.
  auto const local = fit_least_squares(slopes_at(form, p, sizes), missing);
  double const rss = missing.squaredNorm();
  VectorXd const g = slopes_of(form, p, size);
  double const lever = std::sqrt(1.0 + g.dot(local.inverse_information * g));
  double const sd = local.residual_df > 0 ? std::sqrt(rss / local.residual_df) : unknown;
  double const reach = student_quantile(0.95, local.residual_df) * sd * lever;
  double const value = form.value(p, size);
  return {.form = form.name,
          .names = form.parameters,
          .parameters = p,
          .residual_ss = rss,
          .df = local.residual_df,
          .aicc = corrected_aic(rss, static_cast<int>(sizes.size()), static_cast<int>(p.size())),
          .value = value,
          .lower = value - reach,
          .upper = value + reach,
          .lever = lever};
}

/// Why a form cannot be fitted to these points; nothing if it can.
std::optional<std::string> hindrance(TrendForm const& form, VectorXd const& sizes,
                                     VectorXd const& responses) {
  auto const n_sizes = std::set<double>(sizes.begin(), sizes.end()).size();
  if (n_sizes < form.parameters.size())
    return fmt::format("{}: has {} different sizes for {} parameters", form.name, n_sizes,
                       form.parameters.size());
  if (form.needs_positive && responses.minCoeff() <= 0.0)
    return form.name + ": a response is not above 0";
  return std::nullopt;
}

void validate_points(std::vector<double> const& sizes, std::vector<double> const& responses,
                     double size) {
  VALIDATE(sizes.size() == responses.size(),
           fmt::format("size trend: has {} sizes and {} responses. Is a run's result missing?",
                       sizes.size(), responses.size()));
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    VALIDATE(std::isfinite(sizes[k]) && sizes[k] > 0.0,
             fmt::format("size trend: size {} = {:g} (a size is above 0). Was it read?", k + 1,
                         sizes[k]));
    VALIDATE(
        std::isfinite(responses[k]),
        fmt::format("size trend: response {} = {:g} (a run without a result cannot be fitted). "
                    "Leave the run out?",
                    k + 1, responses[k]));
  }
  VALIDATE(std::isfinite(size) && size > 0.0,
           fmt::format("size trend: to the size {:g} (a size is above 0). Which is meant?", size));
  auto const n_sizes = std::set<double>(sizes.begin(), sizes.end()).size();
  VALIDATE(n_sizes >= 2,
           fmt::format("size trend: has {} different size{} (a trend needs two). More runs?",
                       n_sizes, n_sizes == 1 ? "" : "s"));
}

std::vector<std::string> statements_on(Extrapolation const& found, VectorXd const& sizes) {
  std::vector<std::string> all;
  double const nearest = found.size < sizes.minCoeff() ? sizes.minCoeff() : sizes.maxCoeff();
  if (found.size < sizes.minCoeff() || found.size > sizes.maxCoeff())
    all.push_back(
        fmt::format("{:.6g} lies outside the sizes that were run ({:.6g} to {:.6g}), {:.3g} "
                    "times beyond the nearest.",
                    found.size, sizes.minCoeff(), sizes.maxCoeff(),
                    std::max(nearest / found.size, found.size / nearest)));
  if (found.fits.size() > 1)
    all.push_back(
        fmt::format("{} forms give {:.6g} to {:.6g}: the choice of the form alone is worth "
                    "{:.3g}.",
                    found.fits.size(), found.lowest, found.highest, found.highest - found.lowest));
  auto const n_ranked =
      std::ranges::count_if(found.fits, [](TrendFit const& one) { return !std::isnan(one.aicc); });
  if (n_ranked < 2 && found.fits.size() > 1)
    all.push_back(fmt::format("{} points are too few to rank the forms (AICc needs two more points "
                              "than parameters and variance).",
                              sizes.size()));
  return all;
}

} // namespace

Extrapolation extrapolate(std::vector<double> const& sizes, std::vector<double> const& responses,
                          double size, std::vector<TrendForm> const& forms) {
  validate_points(sizes, responses, size);
  VectorXd const D = Eigen::Map<VectorXd const>(sizes.data(), static_cast<Index>(sizes.size()));
  VectorXd const y =
      Eigen::Map<VectorXd const>(responses.data(), static_cast<Index>(responses.size()));
  Extrapolation found{.size = size,
                      .fits = {},
                      .lowest = std::numeric_limits<double>::infinity(),
                      .highest = -std::numeric_limits<double>::infinity(),
                      .left_out = {},
                      .statements = {}};
  for (auto const& form : forms) {
    if (auto const reason = hindrance(form, D, y)) {
      found.left_out.push_back(*reason);
      continue;
    }
    found.fits.push_back(fit_form(form, D, y, size));
    found.lowest = std::min(found.lowest, found.fits.back().value);
    found.highest = std::max(found.highest, found.fits.back().value);
  }
  VALIDATE(!found.fits.empty(),
           fmt::format("size trend: no form can be fitted ({}). More sizes, or fewer parameters?",
                       found.left_out.empty() ? "none is named" : found.left_out.front()));
  found.statements = statements_on(found, D);
  return found;
}

} // namespace coupling::study
