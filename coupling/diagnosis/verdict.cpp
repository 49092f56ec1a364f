#include "coupling/diagnosis/verdict.hpp"

#include "coupling/diagnosis/differences.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::string name(Findings const& findings, int mechanism) {
  return findings.model.mechanisms()[static_cast<std::size_t>(mechanism)].name;
}

std::string names(Findings const& findings, std::vector<int> const& mechanisms) {
  std::vector<std::string> all;
  for (int const j : mechanisms)
    all.push_back(name(findings, j));
  return fmt::format("{}", fmt::join(all, ", "));
}

Hypothesis const& best_cause(Selection const& selection) {
  return *std::ranges::find_if(selection.hypotheses,
                               [](Hypothesis const& one) { return !one.fit.active.empty(); });
}

VectorXd whitened_effect(Findings const& findings, Fit const& fit, int mechanism) {
  if (findings.comparison)
    return findings.comparison->whitener.whiten(
        change_by(findings.model, fit.at, mechanism, fit.residual.size()));
  auto const& own = findings.library.signatures[static_cast<std::size_t>(mechanism)];
  return fit.at.sizes[mechanism] / own.scale * own.whitened.col(0);
}

/// Rivals that imitate one cause of the best hypothesis while its other causes stay.
std::vector<int> rivals_of(Findings const& findings, Fit const& fit, int mechanism, double below) {
  Unknowns const unknowns(findings.model, fit.active, SizePriors::physical);
  std::vector<Index> kept;
  for (Index k = 0; k < unknowns.n_calibrated(); ++k)
    kept.push_back(k);
  for (int const j : fit.active)
    if (j != mechanism)
      kept.push_back(unknowns.place_of_size(j));
  TangentSpace const others(fit.slopes(Eigen::all, kept));
  VectorXd const effect = others.project(whitened_effect(findings, fit, mechanism));
  std::vector<int> rivals;
  for (int j = 0; j < static_cast<int>(findings.library.signatures.size()); ++j) {
    if (std::ranges::count(fit.active, j) > 0)
      continue;
    Signature rival = findings.library.signatures[static_cast<std::size_t>(j)];
    rival.projected = others.project(rival.whitened);
    if (separation(effect, rival) < below)
      rivals.push_back(j);
  }
  return rivals;
}

bool is_above_null(Findings const& findings, Fit const& fit, int mechanism) {
  return findings.null_sizes.size() == 0 ||
         std::abs(fit.at.sizes[mechanism]) >=
             findings.null_multiple * findings.null_sizes[mechanism];
}

std::vector<ParameterFinding> wrong_parameters(Findings const& findings,
                                               VerdictRules const& rules) {
  std::vector<ParameterFinding> found;
  auto const& fit = findings.baseline;
  for (int p = 0; p < static_cast<int>(fit.unknowns.size()); ++p) {
    if (std::abs(fit.unknowns[p]) <= rules.prior_sds)
      continue;
    std::vector<Index> others;
    for (Index k = 0; k < fit.unknowns.size(); ++k)
      if (k != p)
        others.push_back(k);
    TangentSpace const rest(fit.slopes(Eigen::all, others));
    VectorXd const effect = rest.project(fit.unknowns[p] * fit.slopes.col(p));
    ParameterFinding one{p, fit.at.calibrated[p], fit.unknowns[p], {}};
    for (int j = 0; j < static_cast<int>(findings.library.signatures.size()); ++j) {
      Signature rival = findings.library.signatures[static_cast<std::size_t>(j)];
      rival.projected = rest.project(rival.whitened);
      if (separation(effect, rival) < separable)
        one.equivalent.push_back(j);
    }
    found.push_back(one);
  }
  return found;
}

bool contains(Fit const& fit, int mechanism) {
  return std::ranges::count(fit.active, mechanism) > 0;
}

/// Whether `wider` is `fit` with one more cause.
bool widens(Fit const& wider, Fit const& fit) {
  return wider.active.size() == fit.active.size() + 1 &&
         std::ranges::all_of(fit.active, [&](int j) { return contains(wider, j); });
}

/// Causes that stand in the place of one cause of the best hypothesis and fit nearly as well.
std::vector<int> near_rivals(Selection const& selection, Fit const& best, int mechanism,
                             double near) {
  std::vector<int> rivals;
  for (auto const& one : selection.hypotheses) {
    if (one.fit.active.size() != best.active.size() || contains(one.fit, mechanism) ||
        one.fit.objective() - best.objective() > near * selection.tempering)
      continue;
    std::vector<int> others;
    for (int const j : one.fit.active)
      if (!contains(best, j))
        others.push_back(j);
    if (others.size() == 1)
      rivals.push_back(others.front());
  }
  return rivals;
}

/// Causes of the hypotheses that stay possible, the most probable first. A hypothesis less probable
/// than a subset of its own is left out: its last cause is a passenger.
std::vector<int> possible_causes(Selection const& selection, double rival) {
  double best = 0.0;
  for (auto const& one : selection.hypotheses)
    if (!one.fit.active.empty())
      best = std::max(best, one.probability);
  std::vector<int> causes;
  for (auto const& one : selection.hypotheses) {
    bool const is_carried = std::ranges::any_of(selection.hypotheses, [&](auto const& subset) {
      return !subset.fit.active.empty() && widens(one.fit, subset.fit) &&
             subset.probability >= one.probability;
    });
    if (one.fit.active.empty() || is_carried || one.probability < rival * best)
      continue;
    for (int const j : one.fit.active)
      if (std::ranges::count(causes, j) == 0)
        causes.push_back(j);
  }
  std::ranges::stable_sort(causes, std::greater{}, [&](int j) { return selection.inclusion[j]; });
  return causes;
}

void decide_without_alarm(Findings const& findings, Verdict& verdict) {
  if (verdict.parameters.empty()) {
    verdict.statements.emplace_back("nothing wrong found beyond the stated errors");
    return;
  }
  verdict.kind = VerdictKind::named;
  for (auto const& one : verdict.parameters) {
    auto const& parameter = findings.model.calibrated()[static_cast<std::size_t>(one.parameter)];
    verdict.statements.push_back(
        fmt::format("the data fit, with {} = {:.4g} {} instead of {:.4g} ({:.1f} standard "
                    "deviations of its sheet)",
                    parameter.name, one.value, parameter.unit, parameter.mean, one.z));
    if (one.equivalent.empty())
      continue;
    verdict.kind = VerdictKind::undecided;
    verdict.group = one.equivalent;
    verdict.statements.push_back(fmt::format("these data cannot tell {} from {}", parameter.name,
                                             names(findings, one.equivalent)));
  }
}

/// Sorts the causes of the best hypothesis into named ones and, with their rivals, a group.
void name_causes(Findings const& findings, Fit const& fit, VerdictRules const& rules,
                 Verdict& verdict) {
  auto const& selection = findings.selection;
  double const some = 1.0 - selection.probability_of_none;
  for (int const j : fit.active) {
    if (!is_above_null(findings, fit, j)) {
      verdict.statements.push_back(
          fmt::format("{} is not claimed: clean data show sizes like this one", name(findings, j)));
      continue;
    }
    if (selection.inclusion[j] * some < rules.naming)
      continue;
    auto rivals = rivals_of(findings, fit, j, rules.indistinct);
    for (int const near : near_rivals(selection, fit, j, rules.near_objective))
      if (std::ranges::count(rivals, near) == 0)
        rivals.push_back(near);
    if (rivals.empty()) {
      verdict.causes.push_back(j);
      continue;
    }
    verdict.group.push_back(j);
    verdict.group.insert(verdict.group.end(), rivals.begin(), rivals.end());
    verdict.statements.push_back(fmt::format("{} does the same to these data as {}",
                                             name(findings, j), names(findings, rivals)));
  }
}

/// Whether some cause fits in a form only that it hardly has: another one may have it.
bool has_odd_shape(Findings const& findings, Fit const& fit, VerdictRules const& rules,
                   Verdict& verdict) {
  Unknowns const unknowns(findings.model, fit.active, SizePriors::physical);
  bool is_odd = false;
  for (int const j : verdict.causes) {
    auto const& shapes = findings.model.mechanisms()[static_cast<std::size_t>(j)].shapes;
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      auto const place = static_cast<Index>(k);
      double const u = fit.unknowns[unknowns.place_of_size(j) + 1 + place];
      if (std::abs(u) <= rules.shape_sds)
        continue;
      is_odd = true;
      verdict.statements.push_back(fmt::format(
          "{} fits with a {} of {:.3g}{} only, {:.1f} standard deviations from what is known of "
          "it: another cause may have this form",
          name(findings, j), shapes[k].name, fit.at.shapes[static_cast<std::size_t>(j)][place],
          shapes[k].unit == "1" ? "" : " " + shapes[k].unit, std::abs(u)));
    }
  }
  return is_odd;
}

void decide_on_alarm(Findings const& findings, VerdictRules const& rules, Verdict& verdict) {
  auto const& tests = findings.tests;
  auto const& fit = best_cause(findings.selection).fit;
  double const before = findings.baseline.chi_squared - tests.expected;
  double const excess = fit.chi_squared - tests.expected;
  bool const has_failed = excess > rules.failing_sds * tests.expected_sd;
  verdict.explained_share = before > 0.0 ? 1.0 - std::max(excess, 0.0) / before : 1.0;
  bool const helps_nothing =
      findings.selection.probability_of_none > 0.5 && tests.p_omnibus < tests.p_targeted;
  if ((has_failed && verdict.explained_share < rules.explained) || helps_nothing) {
    verdict.kind = VerdictKind::unknown;
    verdict.statements.push_back(
        fmt::format("no known cause explains the misfit: the best, {}, takes {:.0f} % of it",
                    names(findings, fit.active), 100.0 * verdict.explained_share));
    return;
  }
  name_causes(findings, fit, rules, verdict);
  if (verdict.group.empty() && !verdict.causes.empty()) {
    verdict.kind = VerdictKind::named;
    verdict.is_incomplete = has_odd_shape(findings, fit, rules, verdict) || has_failed ||
                            verdict.causes.size() < fit.active.size();
    return;
  }
  verdict.kind = VerdictKind::undecided;
  if (verdict.group.empty())
    verdict.group = possible_causes(findings.selection, rules.rival);
}

} // namespace

std::string_view name_of(VerdictKind kind) {
  switch (kind) {
  case VerdictKind::consistent:
    return "consistent";
  case VerdictKind::named:
    return "named";
  case VerdictKind::undecided:
    return "undecided";
  case VerdictKind::unknown:
    return "unknown";
  }
  return "";
}

Verdict decide(Findings const& findings, VerdictRules const& rules) {
  Verdict verdict;
  verdict.parameters = wrong_parameters(findings, rules);
  if (!findings.tests.is_alarm)
    decide_without_alarm(findings, verdict);
  else if (findings.library.signatures.empty()) {
    verdict.kind = VerdictKind::unknown;
    verdict.explained_share = 0.0;
    verdict.statements.emplace_back("something is wrong, and no cause was offered");
  } else
    decide_on_alarm(findings, rules, verdict);
  return verdict;
}

Verdict pass_gate(Verdict verdict, double elpd_difference, double standard_error,
                  VerdictRules const& rules) {
  VALIDATE(std::isfinite(elpd_difference) && standard_error >= 0.0,
           fmt::format("held-out score: is {:g} with the standard error {:g}. Were runs left out?",
                       elpd_difference, standard_error));
  if (verdict.kind != VerdictKind::named || verdict.causes.empty() ||
      elpd_difference > rules.gate_errors * standard_error)
    return verdict;
  verdict.kind = VerdictKind::undecided;
  verdict.group = std::exchange(verdict.causes, {});
  verdict.statements.push_back(
      fmt::format("not named: on runs that were left out it wins by {:.3g}, standard error {:.3g} "
                  "(more than {:g} times that is asked)",
                  elpd_difference, standard_error, rules.gate_errors));
  return verdict;
}

} // namespace coupling::diagnosis
