#include "coupling/finding/claims.hpp"

#include <algorithm>

namespace coupling::finding {
namespace {

using diagnosis::Diagnosis;
using diagnosis::Hypothesis;

std::vector<int> sorted(std::vector<int> causes) {
  std::ranges::sort(causes);
  return causes;
}

/// The hypothesis of exactly these causes.
Hypothesis const* find_hypothesis(Diagnosis const& found, std::vector<int> const& causes) {
  auto const& all = found.selection.hypotheses;
  auto const one = std::ranges::find_if(
      all, [&](auto const& h) { return sorted(h.fit.active) == sorted(causes); });
  return one == all.end() ? nullptr : &*one;
}

} // namespace

Hypothesis const* claimed_hypothesis(Diagnosis const& found) {
  bool const names = found.verdict.kind == diagnosis::VerdictKind::named;
  return names && !found.verdict.causes.empty() ? find_hypothesis(found, found.verdict.causes)
                                                : nullptr;
}

Hypothesis const* best_wrong_hypothesis(Diagnosis const& found) {
  auto const& claims = found.verdict.causes;
  for (auto const& one : found.selection.hypotheses)
    if (one.fit.active.size() == 1 &&
        std::ranges::find(claims, one.fit.active.front()) == claims.end())
      return &one;
  return nullptr;
}

std::vector<diagnosis::PossibleCause> possible_causes(Diagnosis const& found) {
  constexpr std::size_t most = 5;
  std::vector<diagnosis::PossibleCause> causes;
  for (int const j : found.verdict.group)
    if (auto const* const alone = find_hypothesis(found, {j}); alone && causes.size() < most)
      causes.push_back({j, alone->fit});
  return causes;
}

} // namespace coupling::finding
