#include "coupling/diagnosis/diagnose.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Data, model and Sigma at one point.
struct Weighed {
  ErrorModel errors;
  Comparison comparison;
  SigmaPoint at;
};

Weighed weigh_at(Observations const& observations, Model const& model, ErrorSources const& sources,
                 Parameters const& at, std::vector<int> const& active) {
  auto errors = error_model(observations, model, sources, at, active);
  Comparison comparison{&model, observations.values() - errors.bias,
                        Whitener(errors.covariance, sources.tolerances.largest_jitter)};
  return {std::move(errors), std::move(comparison), {at, active}};
}

/// Sigma at the prior means, the baseline, and both again.
Weighed weigh_at_baseline(Observations const& observations, Model const& model,
                          ErrorSources const& sources) {
  auto first = weigh_at(observations, model, sources, nominal_parameters(model), {});
  auto second = weigh_at(observations, model, sources, fit_baseline(first.comparison).at, {});
  return weigh_at(observations, model, sources, fit_baseline(second.comparison).at, {});
}

/// A selection with all that it stands on.
struct Selected {
  Weighed weighed;
  Fit baseline;
  SignatureLibrary library;
  Selection selection;
};

Selected select_under(Weighed weighed, MisfitTests const& tests,
                      SelectionSettings const& settings) {
  Fit baseline = fit_baseline(weighed.comparison);
  auto library = signature_library(weighed.comparison, baseline);
  auto selection = select_causes(weighed.comparison, baseline, library, tests.expected,
                                 tests.expected_sd, settings);
  return {std::move(weighed), std::move(baseline), std::move(library), std::move(selection)};
}

/// The most probable hypothesis that names anything: under an alarm "none" has no slack to add.
Fit const& best_fit(Selection const& selection) {
  for (auto const& one : selection.hypotheses)
    if (!one.fit.active.empty())
      return one.fit;
  return selection.hypotheses.front().fit;
}

/// A cause that is gone where the error of its own form counts, and is back where it does not, is
/// none: the smaller set stays.
bool only_adds(Selected const& next, Selected const& before) {
  auto wider = best_fit(next.selection).active, narrow = best_fit(before.selection).active;
  std::ranges::sort(wider);
  std::ranges::sort(narrow);
  return wider.size() > narrow.size() && std::ranges::includes(wider, narrow);
}

std::vector<CauseEstimate> estimate(Selected const& selected, double largest_printed) {
  std::vector<CauseEstimate> all;
  auto const& fit = best_fit(selected.selection);
  double const some = 1.0 - selected.selection.probability_of_none;
  for (int const j : fit.active)
    all.push_back(
        {j, std::min(selected.selection.inclusion[j] * some, largest_printed),
         size_interval(selected.weighed.comparison, fit, j, selected.selection.tempering)});
  return all;
}

} // namespace

Diagnosis diagnose(Observations const& observations, Model const& model,
                   ErrorSources const& sources, DiagnosisSettings const& settings) {
  validate(model);
  auto weighed = weigh_at_baseline(observations, model, sources);
  Fit const baseline = fit_baseline(weighed.comparison);
  auto const library = signature_library(weighed.comparison, baseline);
  auto const tests = test_misfit(observations, weighed.comparison, weighed.errors.covariance,
                                 library, settings.misfit);
  std::vector<Detectable> detectable;
  for (auto const& one : library.signatures)
    detectable.push_back({one.name, one.unit, one.smallest_detectable()});

  auto const errors = weighed.errors;
  Selected selected{std::move(weighed), baseline, library, {}};
  if (tests.is_alarm && !library.signatures.empty()) {
    selected = select_under(std::move(selected.weighed), tests, settings.selection);
    for (int k = 0; k < settings.n_iterations; ++k) {
      auto const& best = best_fit(selected.selection);
      auto next = select_under(weigh_at(observations, model, sources, best.at, best.active), tests,
                               settings.selection);
      if (k > 0 && only_adds(next, selected))
        break;
      selected = std::move(next);
    }
  }
  auto verdict = decide({.model = model,
                         .baseline = selected.baseline,
                         .tests = tests,
                         .selection = selected.selection,
                         .library = selected.library,
                         .null_sizes = sources.null_sizes,
                         .null_multiple = sources.tolerances.null_multiple,
                         .comparison = &selected.weighed.comparison},
                        settings.rules);
  auto estimates = selected.selection.hypotheses.empty()
                       ? std::vector<CauseEstimate>{}
                       : estimate(selected, settings.rules.largest_printed);
  return {.errors = errors,
          .baseline = baseline,
          .tests = tests,
          .detectable = std::move(detectable),
          .comparison = std::move(selected.weighed.comparison),
          .sigma_at = std::move(selected.weighed.at),
          .baseline_in_common = std::move(selected.baseline),
          .library = std::move(selected.library),
          .selection = std::move(selected.selection),
          .estimates = std::move(estimates),
          .verdict = std::move(verdict)};
}

VectorXd sizes_on_clean_data(Observations const& observations, MatrixXd const& clean,
                             Model const& model, ErrorSources const& sources) {
  VALIDATE(clean.cols() > 0 && clean.rows() == observations.size(),
           fmt::format("clean data: are {} x {} for {} measured rows. Were they made for the same "
                       "blocks?",
                       clean.rows(), clean.cols(), observations.size()));
  VectorXd squares = VectorXd::Zero(static_cast<Index>(model.mechanisms().size()));
  for (Index set = 0; set < clean.cols(); ++set) {
    auto blocks = observations.blocks();
    for (std::size_t b = 0; b < blocks.size(); ++b)
      blocks[b].values =
          clean.col(set).segment(observations.rows()[b].first, observations.rows()[b].n);
    auto const weighed = weigh_at_baseline(Observations(blocks), model, sources);
    Fit const baseline = fit_baseline(weighed.comparison);
    auto const library = signature_library(weighed.comparison, baseline);
    for (Index j = 0; j < squares.size(); ++j) {
      auto const fit = refit_with(weighed.comparison, baseline, library, static_cast<int>(j));
      squares[j] += fit.at.sizes[j] * fit.at.sizes[j];
    }
  }
  return (squares / static_cast<double>(clean.cols())).cwiseSqrt();
}

} // namespace coupling::diagnosis
