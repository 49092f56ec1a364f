#include "coupling/finding/ranked_causes.hpp"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace coupling::finding {
namespace {

using diagnosis::Diagnosis;
using diagnosis::Fit;
using diagnosis::Hypothesis;
using Eigen::Index;

constexpr double least_shown = 1e-3; ///< probability below which a cause is left out of the list
constexpr double normal_95 = 1.96;

bool holds(std::vector<int> const& list, int j) {
  return std::ranges::count(list, j) > 0;
}

/// The most probable hypothesis that has the cause, or nullptr if the search never fitted it.
Hypothesis const* hypothesis_with(Diagnosis const& found, int mechanism) {
  auto const& all = found.selection.hypotheses;
  auto const at = std::ranges::find_if(
      all, [&](Hypothesis const& one) { return holds(one.fit.active, mechanism); });
  return at == all.end() ? nullptr : &*at;
}

/// ln evidence of the hypothesis over that of "nothing is wrong".
double evidence_over_none(Diagnosis const& found, Hypothesis const* hypothesis) {
  auto const& all = found.selection.hypotheses;
  auto const none =
      std::ranges::find_if(all, [](Hypothesis const& one) { return one.fit.active.empty(); });
  return hypothesis && none != all.end() ? hypothesis->log_evidence - none->log_evidence
                                         : not_known;
}

std::vector<CauseParameter> parameters_in(Diagnosis const& found, diagnosis::Model const& model,
                                          Fit const& fit, int mechanism) {
  auto const& cause = model.mechanisms()[static_cast<std::size_t>(mechanism)];
  auto const size =
      diagnosis::size_interval(found.comparison, fit, mechanism, found.selection.tempering);
  std::vector<CauseParameter> all{{.name = "size",
                                   .value = size.value,
                                   .low = size.low,
                                   .high = size.high,
                                   .unit = cause.unit,
                                   .is_open_low = size.is_open_low,
                                   .is_open_high = size.is_open_high}};
  for (std::size_t k = 0; k < cause.shapes.size(); ++k) {
    auto const& shape = cause.shapes[k];
    double const value = fit.at.shapes[static_cast<std::size_t>(mechanism)][static_cast<Index>(k)];
    // The law's own prior is all that is said of it: data that move the size say little of it.
    all.push_back({.name = shape.name,
                   .value = value,
                   .low = std::max(shape.low, value - normal_95 * shape.sd),
                   .high = std::min(shape.high, value + normal_95 * shape.sd),
                   .unit = shape.unit});
  }
  return all;
}

FoundCause cause_of(Diagnosis const& found, FindingSources const& sources, int mechanism) {
  auto const& cause = sources.model.mechanisms()[static_cast<std::size_t>(mechanism)];
  auto const* hypothesis = hypothesis_with(found, mechanism);
  Fit const fit = hypothesis ? hypothesis->fit
                             : diagnosis::refit_with(found.comparison, found.baseline_in_common,
                                                     found.library, mechanism);
  auto parameters = parameters_in(found, sources.model, fit, mechanism);
  double const probability =
      found.selection.inclusion[mechanism] * (1.0 - found.selection.probability_of_none);
  auto plausibility = plausibility_in_words(std::abs(parameters.front().value) / cause.scale);
  return {.name = cause.name,
          .probability = std::min(probability, sources.settings.rules.largest_printed),
          .log_evidence = evidence_over_none(found, hypothesis),
          .plausibility = std::move(plausibility),
          .parameters = std::move(parameters),
          .is_named = holds(found.verdict.causes, mechanism)};
}

/// A calibrated parameter that is far from its sheet, as a cause with a relative size.
FoundCause cause_of(diagnosis::ParameterFinding const& one, CalibratedValue const& value,
                    FindingSources const& sources, bool is_named) {
  double const size = value.value / value.sheet - 1.0;
  double const half = normal_95 * value.sd / std::abs(value.sheet);
  double const doubt = std::erfc(std::abs(one.z) / std::numbers::sqrt2);
  return {
      .name = cause_name_of(value.name),
      .probability = std::min(1.0 - doubt, sources.settings.rules.largest_printed),
      .log_evidence = not_known,
      .plausibility = fmt::format("{:.1f} standard deviations from its sheet", std::abs(one.z)),
      .parameters =
          {{.name = "size", .value = size, .low = size - half, .high = size + half, .unit = "1"}},
      .is_named = is_named,
      .is_calibrated = true};
}

} // namespace

Fit const& best_fit(Diagnosis const& found) {
  for (auto const& one : found.selection.hypotheses)
    if (!one.fit.active.empty())
      return one.fit;
  return found.baseline;
}

std::string cause_name_of(std::string const& parameter) {
  return parameter == "cohesion_energy_density" ? "cohesion" : parameter;
}

std::string plausibility_in_words(double size_in_scales) {
  std::string const share =
      fmt::format("{:.2g} times the most that a good laboratory meets", size_in_scales);
  if (size_in_scales <= 1.05) // prints as 1
    return "plausible: " + share;
  return (size_in_scales <= 2.5 ? "large: " : "hardly plausible: ") + share;
}

std::vector<FoundCause> ranked_causes(Diagnosis const& found, FindingSources const& sources) {
  std::vector<FoundCause> ranked;
  bool const is_named = found.verdict.kind == diagnosis::VerdictKind::named;
  auto const calibrated = calibrated_values(found, sources.model);
  // Under an alarm the baseline lacks a cause, and its parameters bend to stand in for it.
  if (!found.tests.is_alarm)
    for (auto const& one : found.verdict.parameters)
      ranked.push_back(
          cause_of(one, calibrated[static_cast<std::size_t>(one.parameter)], sources, is_named));
  for (int j = 0; j < found.selection.inclusion.size(); ++j) {
    double const p = found.selection.inclusion[j] * (1.0 - found.selection.probability_of_none);
    if (p >= least_shown || holds(found.verdict.causes, j) || holds(found.verdict.group, j))
      ranked.push_back(cause_of(found, sources, j));
  }
  std::ranges::stable_sort(ranked, [](FoundCause const& a, FoundCause const& b) {
    return a.is_named != b.is_named ? a.is_named : a.probability > b.probability;
  });
  return ranked;
}

std::vector<std::string> group_of(Diagnosis const& found, FindingSources const& sources,
                                  std::vector<FoundCause> const& ranked) {
  std::vector<std::string> group;
  auto const add = [&](std::string const& name) {
    if (std::ranges::count(group, name) == 0)
      group.push_back(name);
  };
  for (auto const& one : found.verdict.parameters)
    if (!found.tests.is_alarm && !one.equivalent.empty())
      add(cause_name_of(sources.model.calibrated()[static_cast<std::size_t>(one.parameter)].name));
  for (int const j : found.verdict.group)
    add(sources.model.mechanisms()[static_cast<std::size_t>(j)].name);
  if (found.verdict.kind == diagnosis::VerdictKind::undecided)
    for (auto const& cause : ranked)
      if (group.size() < 2)
        add(cause.name);
  return group;
}

std::vector<CalibratedValue> calibrated_values(Diagnosis const& found,
                                               diagnosis::Model const& model) {
  Fit const& fit = best_fit(found);
  diagnosis::Unknowns const unknowns(model, fit.active, diagnosis::SizePriors::physical);
  Eigen::MatrixXd curvature = fit.slopes.transpose() * fit.slopes;
  // A Student prior bends the other way far out; the data then speak alone.
  curvature.diagonal() += unknowns.prior_curvature(fit.unknowns).cwiseMax(0.0);
  Eigen::MatrixXd const covariance =
      curvature.ldlt().solve(Eigen::MatrixXd::Identity(curvature.rows(), curvature.cols()));
  std::vector<CalibratedValue> all;
  for (std::size_t k = 0; k < model.calibrated().size(); ++k) {
    auto const& one = model.calibrated()[k];
    auto const p = static_cast<Index>(k);
    double const value = fit.at.calibrated[p];
    double const in_units = one.sd * std::sqrt(std::max(covariance(p, p), 0.0));
    all.push_back({.name = one.name,
                   .value = value,
                   .sd = one.is_logarithmic ? value * in_units : in_units,
                   .sheet = one.mean,
                   .sheet_sd = one.sd,
                   .unit = one.unit,
                   .is_logarithmic = one.is_logarithmic});
  }
  return all;
}

} // namespace coupling::finding
