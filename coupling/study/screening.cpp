#include "coupling/study/screening.hpp"

#include "coupling/study/anova.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace coupling::study {
namespace {

FactorInfluence influence_of(ResponseSurface const& surface, int factor) {
  auto const columns = columns_with_factor(surface, factor);
  auto const row = adjusted_row(surface, "", columns);
  FactorInfluence found{.factor = surface.data.factor_names[static_cast<std::size_t>(factor)],
                        .df = row.df,
                        .ss = row.ss,
                        .share = row.ss / surface.total_ss,
                        .f = row.f,
                        .p = row.p,
                        .p_holm = row.p,
                        .largest_effect = 0.0,
                        .largest_term = {},
                        .is_influential = false,
                        .statement = {}};
  auto const coefficients = surface.coefficients();
  for (int const column : columns) {
    auto const& one = coefficients[static_cast<std::size_t>(column)];
    // Without degrees of freedom all are NaN; the first stands for them.
    if (found.largest_term.empty() || std::abs(one.t) > found.largest_effect) {
      found.largest_effect = std::abs(one.t);
      found.largest_term = one.name;
    }
  }
  return found;
}

std::string statement_of(FactorInfluence const& one, ResponseSurface const& surface, double level) {
  auto const& response = surface.data.response_name;
  if (!(surface.total_ss > 0.0))
    return fmt::format("{} does not vary, so {} has no effect on it to be seen", response,
                       one.factor);
  if (one.df == 0)
    return fmt::format("{} is in no term of {}", one.factor, response);
  if (std::isnan(one.p))
    return fmt::format(
        "{} takes {:.3g} % of the sum of squares of {}; no degree of freedom is left "
        "to tell whether it is influential",
        one.factor, 100.0 * one.share, response);
  return fmt::format("{} is {}influential on {}: {:.3g} % of the sum of squares, p = {:.2g} after "
                     "Holm (level {:g})",
                     one.factor, one.is_influential ? "" : "not ", response, 100.0 * one.share,
                     one.p_holm, level);
}

} // namespace

std::vector<double> adjust_holm(std::vector<double> const& p) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < p.size(); ++k)
    if (!std::isnan(p[k]))
      order.push_back(k);
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return p[k]; });
  std::vector<double> adjusted = p;
  double largest = 0.0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    largest = std::max(largest, static_cast<double>(order.size() - k) * p[order[k]]);
    adjusted[order[k]] = std::min(largest, 1.0);
  }
  return adjusted;
}

std::vector<FactorInfluence> screen_factors(ResponseSurface const& surface, double level) {
  std::vector<FactorInfluence> all;
  std::vector<double> p;
  for (int f = 0; f < surface.n_factors(); ++f) {
    all.push_back(influence_of(surface, f));
    p.push_back(all.back().p);
  }
  auto const adjusted = adjust_holm(p);
  for (std::size_t f = 0; f < all.size(); ++f) {
    all[f].p_holm = adjusted[f];
    all[f].is_influential = adjusted[f] < level;
    all[f].statement = statement_of(all[f], surface, level);
  }
  std::ranges::stable_sort(all, std::greater{}, &FactorInfluence::ss);
  return all;
}

std::vector<OverallInfluence> screen_factors(std::vector<ResponseSurface> const& surfaces,
                                             double level) {
  VALIDATE(!surfaces.empty(), "screening: has no response. Which results are meant?");
  auto const& names = surfaces.front().data.factor_names;
  std::vector<OverallInfluence> all;
  all.reserve(names.size());
  for (auto const& name : names)
    all.push_back({name, 0.0, 0});
  int n_varying = 0;
  for (auto const& surface : surfaces) {
    VALIDATE(
        surface.data.factor_names == names,
        fmt::format("screening: {} and {} have different factors. Were they fitted to the same "
                    "design?",
                    surfaces.front().data.response_name, surface.data.response_name));
    if (!(surface.total_ss > 0.0))
      continue;
    ++n_varying;
    for (auto const& one : screen_factors(surface, level)) {
      auto& sum = *std::ranges::find(all, one.factor, &OverallInfluence::factor);
      sum.mean_share += one.share;
      sum.n_influential += one.is_influential ? 1 : 0;
    }
  }
  for (auto& one : all)
    one.mean_share /= std::max(n_varying, 1);
  std::ranges::stable_sort(all, std::greater{}, &OverallInfluence::mean_share);
  return all;
}

} // namespace coupling::study
