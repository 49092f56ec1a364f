#include "coupling/study/analysis.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace coupling::study {
namespace {

using Out = std::back_insert_iterator<std::string>;

void describe_surface(Out out, ResponseAnalysis const& part, StudyFile const& study) {
  ResponseSurface const& surface = part.surface;
  fmt::format_to(out,
                 "\n{} [{}]: {} model, {} runs, R2 {:.5f}, adjusted {:.5f}, predicted {:.5f}\n",
                 part.response.name, part.response.unit, study.model, surface.n_runs(),
                 surface.r_squared(), surface.adjusted_r_squared(), surface.predicted_r_squared());
  fmt::format_to(out, "  {:<12} {:>14} {:>12} {:>9} {:>10}   95 % interval\n", "coded term",
                 "coefficient", "std. error", "t", "p");
  for (Coefficient const& c : surface.coefficients())
    fmt::format_to(out, "  {:<12} {:>14.7g} {:>12.4g} {:>9.2f} {:>10.2g}   {:.6g} to {:.6g}\n",
                   c.name, c.value, c.standard_error, c.t, c.p, c.lower, c.upper);
}

void describe_row(Out out, AnovaRow const& row) {
  fmt::format_to(out, "  {:<12} {:>4} {:>14.6g} {:>14.6g} {:>10.4g} {:>10.2g}\n", row.name, row.df,
                 row.ss, row.mean_square, row.f, row.p);
}

void describe_anova(Out out, Anova const& anova) {
  fmt::format_to(out, "  {:<12} {:>4} {:>14} {:>14} {:>10} {:>10}   (adjusted)\n", "source", "df",
                 "sum of squares", "mean square", "F", "p");
  describe_row(out, anova.model);
  for (AnovaRow const& row : anova.groups)
    describe_row(out, row);
  for (AnovaRow const& row : anova.terms)
    describe_row(out, row);
  describe_row(out, anova.residual);
  if (anova.pure_error.df > 0) {
    describe_row(out, anova.lack_of_fit);
    describe_row(out, anova.pure_error);
  }
  describe_row(out, anova.total);
}

void describe_calibration(Out out, Analysis const& analysis, StudyFile const& study) {
  if (!analysis.calibration)
    return;
  Calibration const& found = *analysis.calibration;
  fmt::format_to(out, "\nCalibration: chi2 = {:.4g} with {} degrees of freedom, p = {:.3g}\n",
                 found.chi_squared, found.df, found.p);
  for (std::size_t f = 0; f < found.factors.size(); ++f) {
    CalibratedFactor const& factor = found.factors[f];
    auto const text = [&](double value) { return study.factors[f].text(value); };
    fmt::format_to(out, "  {:<8} {}{}\n", factor.name, text(factor.value),
                   factor.is_held
                       ? " (held)"
                       : fmt::format("   95 %: {} to {}{}", text(factor.lower), text(factor.upper),
                                     factor.is_at_bound ? ", at a bound" : ""));
  }
  for (ResponseRoots const& part : analysis.roots)
    for (TargetRoot const& root : part.roots)
      for (StudyFactor const& factor : study.factors)
        if (!study.calibration.held.contains(factor.name))
          fmt::format_to(out, "  {} alone is met at {} = {} (sd {})\n", part.response, factor.name,
                         factor.text(root.value), factor.text(root.sd));
  for (std::string const& statement : found.statements)
    fmt::format_to(out, "  {}\n", statement);
}

void describe_trends(Out out, Analysis const& analysis, StudyFile const& study) {
  for (ResponseTrend const& part : analysis.trends) {
    auto const* const factor = study.factor(study.extrapolation.factor);
    fmt::format_to(out, "\n{} at {} = {}, which was not run:\n", part.response, factor->name,
                   factor->text(part.trend.size));
    for (TrendFit const& fit : part.trend.fits)
      fmt::format_to(out, "  {:<12} {:>12.6g}   95 % if it were true: {:.6g} to {:.6g}\n", fit.form,
                     fit.value, fit.lower, fit.upper);
    for (std::string const& statement : part.trend.statements)
      fmt::format_to(out, "  {}\n", statement);
    for (std::string const& reason : part.trend.left_out)
      fmt::format_to(out, "  left out: {}\n", reason);
  }
}

std::string interval(double low, double high, std::string_view unit) {
  return std::isfinite(low) && std::isfinite(high)
             ? fmt::format("95 %: {:.3g} to {:.3g}{}", low, high, unit)
             : "no interval: too few runs";
}

void describe_forecast(Out out, CostForecast const& one, StudyFile const& study) {
  fmt::format_to(out, "  a run at {} = {} would take {:.3g} s ({})", study.cost.factor,
                 study.cost.text(one.at, study), one.seconds.value,
                 interval(one.seconds.run_lower, one.seconds.run_upper, " s"));
  if (std::isfinite(one.bytes) && study.cost.is_of_grains)
    fmt::format_to(out, " and at most {:.3g} GB", 1e-9 * one.bytes);
  else if (std::isfinite(one.bytes))
    fmt::format_to(out, " and at most {:.3g} GB: {:.3g} grains ({})", 1e-9 * one.bytes,
                   one.grains.value, interval(one.grains.run_lower, one.grains.run_upper, ""));
  fmt::format_to(out, "\n");
}

void describe_cost(Out out, Analysis const& analysis, StudyFile const& study) {
  if (!analysis.cost)
    return;
  CostAnalysis const& cost = *analysis.cost;
  if (cost.law)
    fmt::format_to(out, "\nCost: processor time grows as {}^{:.3g} ({})\n", cost.factor,
                   cost.law->exponent,
                   interval(cost.law->exponent_lower, cost.law->exponent_upper, ""));
  else
    fmt::format_to(out, "\nCost:\n");
  for (CostForecast const& one : cost.forecasts)
    if (cost.law)
      describe_forecast(out, one, study);
  for (std::string const& statement : cost.statements)
    fmt::format_to(out, "  {}\n", statement);
}

} // namespace

std::string describe(Analysis const& analysis, StudyFile const& study) {
  std::string text;
  Out const out(text);
  for (ResponseAnalysis const& part : analysis.responses) {
    describe_surface(out, part, study);
    describe_anova(out, part.anova);
    for (FactorInfluence const& influence : part.influences)
      fmt::format_to(out, "  {}\n", influence.statement);
  }
  if (analysis.responses.size() > 1) {
    fmt::format_to(out, "\nOver all responses:\n");
    for (OverallInfluence const& influence : analysis.influences)
      fmt::format_to(out, "  {:<8} mean share {:.3f}, influential on {} of {}\n", influence.factor,
                     influence.mean_share, influence.n_influential, analysis.responses.size());
  }
  describe_calibration(out, analysis, study);
  describe_trends(out, analysis, study);
  describe_cost(out, analysis, study);
  for (ValidationCheck const& check : analysis.validation)
    fmt::format_to(out, "\n{} {}: {:.6g}, foretold {:.6g} ({:.6g} to {:.6g}): {}", check.run,
                   check.response, check.value, check.foretold.value, check.foretold.run_lower,
                   check.foretold.run_upper, check.is_inside ? "inside" : "OUTSIDE");
  return text;
}

} // namespace coupling::study
