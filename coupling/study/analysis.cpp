#include "coupling/study/analysis.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::study {
namespace {

std::vector<Term> terms_of(StudyFile const& study) {
  int const n = static_cast<int>(study.factors.size());
  if (study.model == "linear")
    return linear_terms(n);
  return study.model == "interactions" ? interaction_terms(n) : quadratic_terms(n);
}

std::vector<FactorRange> ranges_of(StudyFile const& study) {
  std::vector<FactorRange> ranges;
  for (StudyFactor const& factor : study.factors)
    ranges.push_back({.name = factor.name, .low = factor.low, .high = factor.high});
  return ranges;
}

ResponseSurface fit(StudyFile const& study, Eigen::MatrixXd const& coded, std::string name,
                    Eigen::VectorXd response) {
  try {
    return fit_response_surface({.factor_names = names_of(ranges_of(study)),
                                 .coded = coded,
                                 .response_name = std::move(name),
                                 .response = std::move(response)},
                                terms_of(study));
  } catch (dem::InvalidInput const& problem) {
    throw dem::InvalidInput(
        fmt::format("{}: Model = {}: {}", study.file.string(), study.model, problem.what()));
  }
}

std::vector<CalibrationFactor> calibration_factors(StudyFile const& study) {
  std::vector<CalibrationFactor> factors;
  for (FactorRange const& range : ranges_of(study)) {
    auto const held = study.calibration.held.find(range.name);
    factors.push_back({.range = range,
                       .lowest = range.low,
                       .highest = range.high,
                       .held = held == study.calibration.held.end() ? std::nullopt
                                                                    : std::optional(held->second)});
  }
  return factors;
}

void calibrate_into(Analysis& analysis, StudyFile const& study) {
  CalibrationProblem problem{.factors = calibration_factors(study), .targets = {}};
  for (ResponseAnalysis const& part : analysis.responses)
    if (part.response.target)
      problem.targets.push_back({.surface = part.surface,
                                 .value = *part.response.target,
                                 .sd = part.response.uncertainty.value_or(0.0)});
  if (problem.targets.empty())
    return;
  analysis.calibration = calibrate(problem);
  analysis.regions = joint_regions(problem, *analysis.calibration);
  if (study.factors.size() != study.calibration.held.size() + 1)
    return;
  for (CalibrationTarget const& target : problem.targets)
    analysis.roots.push_back({.response = target.surface.data.response_name,
                              .roots = factor_for_target(problem.factors, target)});
}

std::size_t column_of(StudyFile const& study, std::string const& factor) {
  return static_cast<std::size_t>(std::ranges::find(study.factors, factor, &StudyFactor::name) -
                                  study.factors.begin());
}

std::vector<double> column(Eigen::MatrixXd const& natural, std::size_t f) {
  Eigen::VectorXd const values = natural.col(static_cast<Eigen::Index>(f));
  return {values.begin(), values.end()};
}

TrendForm packing_form_of(PackingPlan const& plan, double largest_size) {
  if (plan.coarse.empty())
    return packing_form(plan.fine_share, plan.compaction_index, largest_size);
  std::vector<GrainClass> coarse;
  for (SizeClass const& one : plan.coarse)
    coarse.push_back(
        {.size = one.diameter, .share = one.mass_fraction, .packing = 0.5}); // not read
  return packing_form(std::move(coarse), plan.fine_share, plan.compaction_index);
}

void extrapolate_into(Analysis& analysis, ResultsTable const& table) {
  auto const& wanted = table.study.extrapolation;
  if (wanted.factor.empty())
    return;
  auto const sizes = column(table.natural(), column_of(table.study, wanted.factor));
  for (ResponseAnalysis const& part : analysis.responses) {
    if (std::ranges::count(wanted.responses, part.response.name) == 0)
      continue;
    Eigen::VectorXd const& y = part.surface.data.response;
    std::vector<double> const responses(y.begin(), y.end());
    std::vector<std::string> left_out;
    auto forms = trend_forms(wanted, sizes, responses, left_out);
    auto trend = extrapolate(sizes, responses, wanted.value, forms);
    trend.left_out.insert(trend.left_out.end(), left_out.begin(), left_out.end());
    analysis.trends.push_back({.response = part.response.name,
                               .trend = std::move(trend),
                               .sizes = sizes,
                               .responses = responses,
                               .forms = std::move(forms)});
  }
}

void validate_into(Analysis& analysis, ResultsTable const& table) {
  for (std::size_t const r : table.validation()) {
    ResultRow const& row = table.rows[r];
    Eigen::VectorXd coded(static_cast<Eigen::Index>(table.study.factors.size()));
    for (Eigen::Index f = 0; f < coded.size(); ++f) {
      auto const k = static_cast<std::size_t>(f);
      coded[f] = table.study.factors[k].coded(row.run.natural[k]);
    }
    for (ResponseAnalysis const& part : analysis.responses) {
      double const value = row.value(part.response.quantity);
      auto const foretold = part.surface.predict(coded);
      analysis.validation.push_back(
          {.run = row.run.id,
           .response = part.response.name,
           .value = value,
           .foretold = foretold,
           .is_inside = value >= foretold.run_lower && value <= foretold.run_upper});
    }
  }
}

} // namespace

std::vector<TrendForm> trend_forms(ExtrapolationPlan const& plan, std::vector<double> const& sizes,
                                   std::vector<double> const& responses,
                                   std::vector<std::string>& left_out) {
  std::vector<TrendForm> forms;
  for (std::string const& name : plan.forms) {
    if (name == "linear")
      forms.push_back(linear_form());
    else if (name == "quadratic")
      forms.push_back(quadratic_form());
    else if (name == "logarithmic")
      forms.push_back(logarithmic_form());
    else if (name == "power")
      forms.push_back(power_form(sizes, responses));
    else if (std::ranges::all_of(responses, [](double y) { return y > 0.0 && y < 1.0; }))
      forms.push_back(packing_form_of(plan.packing, std::ranges::max(sizes)));
    else
      left_out.push_back("packing model: a response is no porosity (between 0 and 1)");
  }
  return forms;
}

void validate_model(StudyPlan const& plan) {
  if (plan.study.factors.empty())
    return;
  auto const n_runs = static_cast<Eigen::Index>(plan.runs.size());
  Eigen::MatrixXd coded(n_runs, static_cast<Eigen::Index>(plan.study.factors.size()));
  for (Eigen::Index r = 0; r < n_runs; ++r)
    for (Eigen::Index f = 0; f < coded.cols(); ++f) {
      auto const k = static_cast<std::size_t>(f);
      coded(r, f) = plan.study.factors[k].coded(plan.runs[static_cast<std::size_t>(r)].natural[k]);
    }
  fit(plan.study, coded, "design", Eigen::VectorXd::Zero(n_runs));
}

Analysis analyse(ResultsTable const& table) {
  Analysis analysis;
  std::vector<ResponseSurface> surfaces;
  for (StudyResponse const& response : table.study.responses) {
    auto surface = fit(table.study, table.coded(), response.name, table.response(response));
    surfaces.push_back(surface);
    auto anova = analyse_variance(surface);
    auto influences = screen_factors(surface);
    analysis.responses.push_back({.response = response,
                                  .surface = std::move(surface),
                                  .anova = std::move(anova),
                                  .influences = std::move(influences)});
  }
  if (surfaces.empty())
    return analysis;
  analysis.influences = screen_factors(surfaces);
  calibrate_into(analysis, table.study);
  extrapolate_into(analysis, table);
  if (!table.study.cost.factor.empty())
    analysis.cost = analyse_cost(table);
  validate_into(analysis, table);
  return analysis;
}

std::optional<Analysis> analyse_if_complete(ResultsTable const& table) {
  bool const is_complete =
      !table.rows.empty() && std::ranges::all_of(table.rows, &ResultRow::is_done);
  if (table.study.responses.empty() || !is_complete)
    return std::nullopt;
  return analyse(table);
}

std::vector<double> calibrated_point(Analysis const& analysis) {
  std::vector<double> point;
  if (analysis.calibration)
    for (CalibratedFactor const& factor : analysis.calibration->factors)
      point.push_back(factor.value);
  return point;
}

} // namespace coupling::study
