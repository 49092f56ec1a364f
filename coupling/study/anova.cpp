#include "coupling/study/anova.hpp"

#include "coupling/study/distributions.hpp"
#include "coupling/study/replicates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace coupling::study {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

AnovaRow plain_row(std::string name, double ss, int df) {
  return {.name = std::move(name),
          .df = df,
          .ss = ss,
          .mean_square = df > 0 ? ss / df : unknown,
          .f = unknown,
          .p = unknown,
          .sequential_ss = unknown};
}

AnovaRow tested_row(std::string name, double ss, int df, double error_ss, int error_df) {
  AnovaRow row = plain_row(std::move(name), ss, df);
  if (df > 0 && error_df > 0) {
    // No effect beside no error is no effect.
    row.f = ss == 0.0 ? 0.0 : row.mean_square / (error_ss / error_df);
    row.p = fisher_p(row.f, df, error_df);
  }
  return row;
}

std::vector<AnovaRow> rows_of_terms(ResponseSurface const& surface) {
  std::vector<AnovaRow> rows;
  for (std::size_t t = 0; t < surface.terms.size(); ++t) {
    int const column = static_cast<int>(t) + 1;
    rows.push_back(
        adjusted_row(surface, name_of(surface.terms[t], surface.data.factor_names), {column}));
    rows.back().sequential_ss = surface.fit.sequential[column];
  }
  return rows;
}

} // namespace

std::vector<int> columns_of(ResponseSurface const& surface, TermGroup group) {
  std::vector<int> columns;
  for (std::size_t t = 0; t < surface.terms.size(); ++t)
    if (group_of(surface.terms[t]) == group)
      columns.push_back(static_cast<int>(t) + 1);
  return columns;
}

std::vector<int> columns_with_factor(ResponseSurface const& surface, int factor) {
  std::vector<int> columns;
  for (std::size_t t = 0; t < surface.terms.size(); ++t)
    if (std::ranges::count(surface.terms[t], factor) > 0)
      columns.push_back(static_cast<int>(t) + 1);
  return columns;
}

AnovaRow adjusted_row(ResponseSurface const& surface, std::string name,
                      std::vector<int> const& columns) {
  auto const& fit = surface.fit;
  return tested_row(std::move(name), columns.empty() ? 0.0 : fit.adjusted_ss(columns),
                    static_cast<int>(columns.size()), fit.residual_ss, fit.residual_df);
}

Anova analyse_variance(ResponseSurface const& surface) {
  auto const& fit = surface.fit;
  std::vector<int> all(surface.terms.size());
  std::iota(all.begin(), all.end(), 1);
  std::vector<AnovaRow> groups;
  for (auto const group : {TermGroup::linear, TermGroup::interaction, TermGroup::square})
    if (auto const columns = columns_of(surface, group); !columns.empty())
      groups.push_back(adjusted_row(surface, name_of(group), columns));
  auto const pure = pure_error(surface.data.coded, surface.data.response);
  // Beside a fit without residuals the pure error's rounding must not make it negative.
  double const lack = std::max(fit.residual_ss - pure.ss, 0.0);
  return {.model = adjusted_row(surface, "model", all),
          .groups = std::move(groups),
          .terms = rows_of_terms(surface),
          .residual = plain_row("residual", fit.residual_ss, fit.residual_df),
          .lack_of_fit =
              tested_row("lack of fit", lack, fit.residual_df - pure.df, pure.ss, pure.df),
          .pure_error = plain_row("pure error", pure.ss, pure.df),
          .total = plain_row("total", surface.total_ss, surface.n_runs() - 1)};
}

} // namespace coupling::study
