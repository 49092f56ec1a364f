#include "coupling/study/analysis.hpp"

#include "coupling/record/atomic_file.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace coupling::study {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json row_json(AnovaRow const& row) {
  return {{"source", row.name},
          {"df", row.df},
          {"sum_of_squares", number(row.ss)},
          {"mean_square", number(row.mean_square)},
          {"F", number(row.f)},
          {"p", number(row.p)},
          {"sequential_sum_of_squares", number(row.sequential_ss)}};
}

Json anova_json(Anova const& anova) {
  Json rows = Json::array({row_json(anova.model)});
  for (auto const* part : {&anova.groups, &anova.terms})
    for (AnovaRow const& row : *part)
      rows.push_back(row_json(row));
  for (AnovaRow const* row : {&anova.residual, &anova.lack_of_fit, &anova.pure_error, &anova.total})
    rows.push_back(row_json(*row));
  return rows;
}

Json response_json(ResponseAnalysis const& part) {
  ResponseSurface const& surface = part.surface;
  Json json{{"name", part.response.name},
            {"unit", part.response.unit},
            {"runs", surface.n_runs()},
            {"R2", number(surface.r_squared())},
            {"R2_adjusted", number(surface.adjusted_r_squared())},
            {"R2_predicted", number(surface.predicted_r_squared())},
            {"anova", anova_json(part.anova)}};
  for (Coefficient const& c : surface.coefficients())
    json["coefficients"].push_back({{"term", c.name},
                                    {"value", number(c.value)},
                                    {"standard_error", number(c.standard_error)},
                                    {"t", number(c.t)},
                                    {"p", number(c.p)},
                                    {"low", number(c.lower)},
                                    {"high", number(c.upper)}});
  for (FactorInfluence const& influence : part.influences)
    json["influences"].push_back({{"factor", influence.factor},
                                  {"share", number(influence.share)},
                                  {"p_holm", number(influence.p_holm)},
                                  {"influential", influence.is_influential}});
  return json;
}

Json region_json(JointRegion const& region, Calibration const& found) {
  auto const name = [&](int factor) {
    return found.factors[static_cast<std::size_t>(factor)].name;
  };
  return {{"factors", {name(region.first), name(region.second)}},
          {"chi_squared", number(region.threshold)},
          {"lines", region.lines}};
}

Json calibration_json(Analysis const& analysis) {
  Calibration const& found = *analysis.calibration;
  Json json{{"chi_squared", number(found.chi_squared)},
            {"df", found.df},
            {"p", number(found.p)},
            {"contradicts", found.contradicts},
            {"statements", found.statements}};
  for (CalibratedFactor const& factor : found.factors)
    json["factors"].push_back({{"name", factor.name},
                               {"value", number(factor.value)},
                               {"low", number(factor.lower)},
                               {"high", number(factor.upper)},
                               {"held", factor.is_held},
                               {"at_bound", factor.is_at_bound}});
  for (CalibratedTarget const& target : found.targets)
    json["targets"].push_back({{"response", target.response},
                               {"target", number(target.target)},
                               {"value", number(target.value)},
                               {"residual", number(target.residual)},
                               {"lowest", number(target.lowest)},
                               {"highest", number(target.highest)},
                               {"reachable", target.is_reachable}});
  for (ResponseRoots const& part : analysis.roots)
    for (TargetRoot const& root : part.roots)
      json["roots"].push_back(
          {{"response", part.response}, {"value", number(root.value)}, {"sd", number(root.sd)}});
  for (JointRegion const& region : analysis.regions)
    json["region"].push_back(region_json(region, found));
  return json;
}

Json prediction_json(CostPrediction const& one) {
  return {{"value", number(one.value)},
          {"low", number(one.run_lower)},
          {"high", number(one.run_upper)}};
}

Json cost_json(CostAnalysis const& cost) {
  Json json{{"factor", cost.factor}, {"runs", cost.sizes.size()}};
  if (cost.law) {
    json["exponent"] = number(cost.law->exponent);
    json["low"] = number(cost.law->exponent_lower);
    json["high"] = number(cost.law->exponent_upper);
    json["seconds_at_1"] = number(cost.law->factor);
  }
  for (CostForecast const& one : cost.forecasts)
    json["forecasts"].push_back({{"at", number(one.at)},
                                 {"cpu_seconds", prediction_json(one.seconds)},
                                 {"grains", prediction_json(one.grains)},
                                 {"bytes", number(one.bytes)},
                                 {"bytes_high", number(one.bytes_upper)}});
  json["statements"] = cost.statements;
  return json;
}

Json trend_json(ResponseTrend const& part) {
  Json json{{"response", part.response},
            {"size", number(part.trend.size)},
            {"lowest", number(part.trend.lowest)},
            {"highest", number(part.trend.highest)},
            {"left_out", part.trend.left_out}};
  for (TrendFit const& fit : part.trend.fits)
    json["forms"].push_back({{"form", fit.form},
                             {"value", number(fit.value)},
                             {"low", number(fit.lower)},
                             {"high", number(fit.upper)},
                             {"aicc", number(fit.aicc)}});
  return json;
}

Json analysis_json(Analysis const& analysis, StudyFile const& study) {
  Json json{{"model", study.model}};
  for (ResponseAnalysis const& part : analysis.responses)
    json["responses"].push_back(response_json(part));
  if (analysis.calibration)
    json["calibration"] = calibration_json(analysis);
  for (ResponseTrend const& part : analysis.trends)
    json["extrapolation"].push_back(trend_json(part));
  if (analysis.cost)
    json["cost"] = cost_json(*analysis.cost);
  for (ValidationCheck const& check : analysis.validation)
    json["validation"].push_back({{"run", check.run},
                                  {"response", check.response},
                                  {"value", number(check.value)},
                                  {"foretold", number(check.foretold.value)},
                                  {"low", number(check.foretold.run_lower)},
                                  {"high", number(check.foretold.run_upper)},
                                  {"inside", check.is_inside}});
  return json;
}

} // namespace

void write_analysis(Analysis const& analysis, StudyFile const& study,
                    std::filesystem::path const& folder) {
  auto const file = folder / "study.json";
  Json json = Json::parse(read_file(file));
  json["analysis"] = analysis_json(analysis, study);
  write_file(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  write_file(folder / "analysis.txt", describe(analysis, study));
}

} // namespace coupling::study
