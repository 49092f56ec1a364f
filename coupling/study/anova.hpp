#pragma once

#include "coupling/study/response_surface.hpp"

#include <string>
#include <vector>

namespace coupling::study {

/// A line of an analysis of variance. What a line does not have is NaN (a total has no F).
struct AnovaRow {
  std::string name;
  int df;
  double ss;          ///< [unit of the response squared]
  double mean_square; ///< ss / df
  double f;           ///< mean square over that of the residual; of the pure error for lack of fit
  double p;           ///< P(F >= f)
  double
      sequential_ss; ///< terms only: what the term takes when added after those above it (type I)
};

/// Sums of squares of terms and groups are adjusted (type III of SAS and Minitab): what the
/// residual grows by when the term, or the group, leaves the full model. In coded units; for
/// designs that are not orthogonal they do not add up to that of the model. Sequential ones do.
/// Source: Montgomery, Peck, Vining (2012), sections 3.3 and 4.5.
struct Anova {
  AnovaRow model;
  std::vector<AnovaRow> groups; ///< linear, interaction, square: those that the model has
  std::vector<AnovaRow> terms;  ///< in the model's order
  AnovaRow residual;
  /// Residual = lack of fit + pure error, where runs stand at the same point; else without degrees
  /// of freedom. F of the lack of fit against the pure error.
  AnovaRow lack_of_fit;
  AnovaRow pure_error;
  AnovaRow total; ///< about the mean, n_runs - 1
};

Anova analyse_variance(ResponseSurface const& surface);

/// Columns of the surface's fit that hold terms of a group, or a factor in any term.
std::vector<int> columns_of(ResponseSurface const& surface, TermGroup group);
std::vector<int> columns_with_factor(ResponseSurface const& surface, int factor);

/// Adjusted sum of squares of these columns, tested against the residual.
AnovaRow adjusted_row(ResponseSurface const& surface, std::string name,
                      std::vector<int> const& columns);

} // namespace coupling::study
