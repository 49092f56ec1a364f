#include "coupling/study/calibration_misfit.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::study {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

void validate_factor(CalibrationFactor const& factor) {
  auto const& name = factor.range.name;
  VALIDATE(std::isfinite(factor.lowest) && std::isfinite(factor.highest) &&
               factor.lowest < factor.highest,
           fmt::format("calibration: {} = {} to {} (the lower bound must be below the upper). Hold "
                       "it?",
                       name, factor.lowest, factor.highest));
  VALIDATE(!factor.held || std::isfinite(*factor.held),
           fmt::format("calibration: {} = {} is held (it must be a number). At which value?", name,
                       factor.held.value_or(0.0)));
}

void validate_target(CalibrationTarget const& target, std::vector<std::string> const& factors) {
  auto const& surface = target.surface;
  auto const& name = surface.data.response_name;
  VALIDATE(surface.data.factor_names == factors,
           fmt::format("calibration: {} was fitted to other factors (all targets share theirs). Is "
                       "another surface meant?",
                       name));
  VALIDATE(std::isfinite(target.value),
           fmt::format("calibration: target {} = {} (a target is a number). Was it measured?", name,
                       target.value));
  VALIDATE(
      std::isfinite(target.sd) && target.sd >= 0.0,
      fmt::format("calibration: target {} has the standard uncertainty {} (0 or more). How well "
                  "is it known?",
                  name, target.sd));
  VALIDATE(target.sd > 0.0 || surface.fit.residual_sd() > 0.0,
           fmt::format("calibration: target {} has the standard uncertainty 0 and its surface none "
                       "(residuals could not be weighed). How well is it known?",
                       name));
}

} // namespace

TargetResidual residual_of(CalibrationTarget const& target, SurfaceSpread spread,
                           VectorXd const& coded) {
  auto const& [surface, value, sd] = target;
  auto const& fit = surface.fit;
  VectorXd const z = regressors(surface.terms, coded);
  VectorXd const Cz = fit.inverse_information * z;
  bool const knows_error = fit.residual_df > 0;
  double const own = knows_error ? fit.residual_variance() : 0.0;
  double const of_run = spread == SurfaceSpread::run ? 1.0 : 0.0;
  double const variance = sd * sd + own * (of_run + z.dot(Cz));
  double const s = std::sqrt(variance), miss = z.dot(fit.coefficients) - value;
  VectorXd slope = surface.gradient(coded) / s;
  for (Index f = 0; f < coded.size(); ++f)
    for (std::size_t t = 0; t < surface.terms.size(); ++t) // d s^2 = 2 own (C z) . dz
      slope[f] -= miss / (s * variance) * own * Cz[static_cast<Index>(t) + 1] *
                  slope_of(surface.terms[t], coded, static_cast<int>(f));
  return {.value = miss / s, .combined_sd = s, .slope = std::move(slope)};
}

ResidualsAt residuals_of(CalibrationProblem const& problem) {
  return [&problem](VectorXd const& coded) {
    auto const n = static_cast<Index>(problem.targets.size());
    Residuals all{VectorXd(n), Eigen::MatrixXd(n, coded.size())};
    for (Index j = 0; j < n; ++j) {
      auto const one =
          residual_of(problem.targets[static_cast<std::size_t>(j)], problem.spread, coded);
      all.values[j] = one.value;
      all.slopes.row(j) = one.slope;
    }
    return all;
  };
}

ResidualsAt residuals_of(CalibrationTarget const& target, SurfaceSpread spread) {
  return [&target, spread](VectorXd const& coded) {
    auto const one = residual_of(target, spread, coded);
    return Residuals{VectorXd::Constant(1, one.value), one.slope.transpose()};
  };
}

Box box_of(std::vector<CalibrationFactor> const& factors) {
  auto const k = static_cast<Index>(factors.size());
  Box box{VectorXd(k), VectorXd(k)};
  for (Index f = 0; f < k; ++f) {
    auto const& factor = factors[static_cast<std::size_t>(f)];
    box.low[f] = factor.range.to_coded(factor.held.value_or(factor.lowest));
    box.high[f] = factor.range.to_coded(factor.held.value_or(factor.highest));
  }
  return box;
}

VectorXd coded_of(std::vector<CalibrationFactor> const& factors,
                  std::vector<double> const& natural) {
  VALIDATE(natural.size() == factors.size(),
           fmt::format("calibration: a point has {} values for {} factors. Is a factor missing?",
                       natural.size(), factors.size()));
  VectorXd coded(static_cast<Index>(factors.size()));
  for (std::size_t f = 0; f < factors.size(); ++f)
    coded[static_cast<Index>(f)] = factors[f].range.to_coded(natural[f]);
  return coded;
}

std::vector<double> natural_of(std::vector<CalibrationFactor> const& factors,
                               VectorXd const& coded) {
  std::vector<double> natural;
  for (std::size_t f = 0; f < factors.size(); ++f) {
    auto const& [range, lowest, highest, held] = factors[f];
    double const value = range.to_natural(coded[static_cast<Index>(f)]);
    // The way through coded units must not leave the bounds by a rounding.
    natural.push_back(held ? *held : std::clamp(value, lowest, highest));
  }
  return natural;
}

void validate_calibration(CalibrationProblem const& problem) {
  VALIDATE(!problem.targets.empty(),
           "calibration: has no targets (there is nothing to meet). Which results are known?");
  std::vector<FactorRange> ranges;
  for (auto const& factor : problem.factors)
    ranges.push_back(factor.range);
  validate_factors(ranges);
  for (auto const& factor : problem.factors)
    validate_factor(factor);
  for (auto const& target : problem.targets)
    validate_target(target, names_of(ranges));
  VALIDATE(std::ranges::any_of(problem.factors, [](auto const& one) { return !one.held; }),
           "calibration: every factor is held (there is nothing to calibrate). Free one?");
}

double chi_squared(CalibrationProblem const& problem, std::vector<double> const& natural) {
  return residuals_of(problem)(coded_of(problem.factors, natural)).values.squaredNorm();
}

} // namespace coupling::study
