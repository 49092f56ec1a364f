#include "coupling/diagnosis/selection.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <set>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

using Causes = std::set<int>;

Causes causes_of(Fit const& fit) {
  return {fit.active.begin(), fit.active.end()};
}

double log_choose(double n, double k) {
  return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
}

/// P [r ; -u] of a fit for scores of what it lacks. Its own slopes are projected out, too: a
/// partner is worth what the fit itself cannot take over.
VectorXd scores_after(Comparison const& comparison, Fit const& fit,
                      SignatureLibrary const& library) {
  Unknowns const unknowns(*comparison.model, fit.active, SizePriors::physical);
  TangentSpace const own(fit.slopes);
  VectorXd extended(own.n_extended());
  extended << fit.residual, -unknowns.prior_residual(fit.unknowns);
  VectorXd const residual = own.project_extended(extended);
  VectorXd scores(static_cast<Index>(library.signatures.size()));
  for (Index j = 0; j < scores.size(); ++j) {
    Signature signature = library.signatures[static_cast<std::size_t>(j)];
    signature.projected = own.project(signature.whitened);
    scores[j] = score_of(signature, residual).value;
  }
  return scores;
}

std::vector<int> best_by(VectorXd const& scores, Causes const& without, int count) {
  std::vector<int> order;
  for (int j = 0; j < scores.size(); ++j)
    if (!without.contains(j))
      order.push_back(j);
  std::ranges::stable_sort(order, std::greater{}, [&](int j) { return scores[j]; });
  order.resize(std::min(order.size(), static_cast<std::size_t>(count)));
  return order;
}

/// The search's state: every set of causes is fitted once.
class Search {
public:
  Search(Comparison const& comparison, SignatureLibrary const& library)
      : comparison_(comparison), library_(library) {}

  /// Of two fits of a set the one that lies deeper.
  void keep(Fit fit) {
    auto const [place, is_new] = places_.emplace(causes_of(fit), found_.size());
    if (!is_new && found_[place->second].fit.objective() <= fit.objective())
      return;
    double const evidence = log_evidence(comparison_, fit);
    Hypothesis one{std::move(fit), evidence, 0.0, 0.0};
    if (is_new)
      found_.push_back(std::move(one));
    else
      found_[place->second] = std::move(one);
  }

  void extend(Fit const& base, int count) {
    auto const own = causes_of(base);
    for (int const j : best_by(scores_after(comparison_, base, library_), own, count)) {
      Causes wider = own;
      wider.insert(j);
      if (!places_.contains(wider))
        keep(refit_with(comparison_, base, library_, j));
    }
  }

  /// The subsets of a fit with one cause less, once more from where it ended: a partner may have
  /// led out of a valley in which a smaller set was caught.
  void narrow(Fit const& wide) {
    Unknowns const before(*comparison_.model, wide.active, SizePriors::physical);
    for (int const j : wide.active) {
      std::vector<int> active;
      std::ranges::remove_copy(wide.active, std::back_inserter(active), j);
      Unknowns const after(*comparison_.model, active, SizePriors::physical);
      keep(fit_hypothesis(comparison_, active, after.out_of(before, wide.unknowns)));
    }
  }

  /// Partners for each cause of a pair: the cause that came last may have a better one than its
  /// base.
  void exchange(Fit const& pair, int count) {
    for (int const j : pair.active)
      extend(Fit(found_[places_.at({j})].fit), count); // a copy, since found_ grows
  }

  /// The best by evidence among sets of `n_causes`.
  std::vector<Fit> best(std::size_t n_causes, int count) const {
    std::vector<Hypothesis const*> order;
    for (auto const& one : found_)
      if (one.fit.active.size() == n_causes)
        order.push_back(&one);
    std::ranges::stable_sort(order, std::greater{}, &Hypothesis::log_evidence);
    std::vector<Fit> fits;
    for (std::size_t k = 0; k < order.size() && k < static_cast<std::size_t>(count); ++k)
      fits.push_back(order[k]->fit);
    return fits;
  }

  double least_chi_squared() const {
    return std::ranges::min(found_, {}, [](Hypothesis const& h) { return h.fit.chi_squared; })
        .fit.chi_squared;
  }
  std::vector<Hypothesis> take() { return std::move(found_); }

private:
  Comparison const& comparison_;
  SignatureLibrary const& library_;
  std::map<Causes, std::size_t> places_; ///< in found_
  std::vector<Hypothesis> found_;
};

} // namespace

Fit refit_with(Comparison const& comparison, Fit const& subset, SignatureLibrary const& library,
               int added) {
  Unknowns const before(*comparison.model, subset.active, SizePriors::physical);
  auto active = subset.active;
  active.push_back(added);
  Unknowns const after(*comparison.model, active, SizePriors::physical);
  auto const& signature = library.signatures[static_cast<std::size_t>(added)];
  VectorXd start = VectorXd::Zero(after.size());
  start.head(before.size()) = subset.unknowns;
  TangentSpace const own(subset.slopes);
  VectorXd extended(own.n_extended());
  extended << subset.residual, -before.prior_residual(subset.unknowns);
  Signature left = signature;
  left.projected = own.project(signature.whitened);
  double const u = score_of(left, own.project_extended(extended)).size / signature.scale;
  // A size of 0 hides its shape parameters and, at a bound, itself.
  double& size = start[after.place_of_size(added)];
  size = std::abs(u) > 0.1 ? std::clamp(u, -2.0, 2.0) : std::copysign(0.1, u);
  Fit best = fit_hypothesis(comparison, active, start);
  // A strong effect can lie beyond a linear estimate's valley: a second start on the larger side.
  if (std::abs(u) > 1.0) {
    size = std::copysign(0.5, u);
    Fit other = fit_hypothesis(comparison, active, start);
    if (other.objective() < best.objective())
      best = std::move(other);
  }
  return best;
}

void weigh(Selection& selection, double expected, SelectionSettings const& settings,
           Index n_mechanisms) {
  double least = no_bound, largest = -no_bound, sum = 0.0;
  for (auto const& one : selection.hypotheses)
    least = std::min(least, one.fit.chi_squared);
  selection.tempering = std::max(1.0, least / expected);
  for (auto& one : selection.hypotheses) {
    auto const k = one.fit.active.size();
    one.log_prior = std::log(settings.prior_shares[std::min<std::size_t>(k, 3)]) -
                    log_choose(static_cast<double>(n_mechanisms), static_cast<double>(k));
    largest = std::max(largest, one.log_evidence / selection.tempering + one.log_prior);
  }
  for (auto& one : selection.hypotheses)
    sum += one.probability =
        std::exp(one.log_evidence / selection.tempering + one.log_prior - largest);
  selection.inclusion = VectorXd::Zero(n_mechanisms);
  selection.probability_of_none = 0.0;
  double some = 0.0; // summed apart: 1 - P(none) cancels where nothing is wrong
  for (auto& one : selection.hypotheses) {
    one.probability /= sum;
    (one.fit.active.empty() ? selection.probability_of_none : some) += one.probability;
    for (int const j : one.fit.active)
      selection.inclusion[j] += one.probability;
  }
  if (some > 0.0)
    selection.inclusion /= some;
  std::ranges::stable_sort(selection.hypotheses, std::greater{}, &Hypothesis::probability);
}

Selection select_causes(Comparison const& comparison, Fit const& baseline,
                        SignatureLibrary const& library, double expected, double expected_sd,
                        SelectionSettings const& settings) {
  auto const m = static_cast<int>(library.signatures.size());
  double const failing = expected + settings.failing_sds * expected_sd;
  Search search(comparison, library);
  search.keep(baseline);
  search.extend(baseline,
                baseline.chi_squared > settings.huge_share * expected ? m : settings.n_screened);
  for (auto const& base : search.best(1, settings.n_bases))
    search.extend(base, settings.n_partners);
  for (auto const& pair : search.best(2, settings.n_bases))
    search.narrow(pair);
  for (auto const& pair : search.best(2, 1))
    search.exchange(pair, settings.n_partners);
  if (search.least_chi_squared() > failing)
    for (auto const& base : search.best(2, 1))
      search.extend(base, settings.n_partners);
  Selection selection{search.take(), 1.0, {}, 0.0};
  weigh(selection, expected, settings, m);
  return selection;
}

} // namespace coupling::diagnosis
