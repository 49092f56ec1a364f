#pragma once

#include "coupling/study/response_surface.hpp"

#include <string>
#include <vector>

namespace coupling::study {

/// How much a response hangs on one factor: all terms that hold the factor, tested together.
struct FactorInfluence {
  std::string factor;
  int df;        ///< number of those terms
  double ss;     ///< their adjusted sum of squares
  double share;  ///< ss / total; interactions count for both factors, so shares may exceed 1
  double f, p;   ///< against the residual
  double p_holm; ///< p of the family of factors, after Holm
  double largest_effect;    ///< largest |t| of those terms (the standardised effect)
  std::string largest_term; ///< its name
  bool is_influential;      ///< p_holm < 0.05; false where no degree of freedom is left
  std::string statement; ///< "E is influential on F: 99.9 % of the sum of squares, p = 1e-8 (Holm)"
};

/// Sorted, the largest share first.
/// Source: Holm, Scand. J. Stat. 6 (1979) 65.
/// @param level  of the test of all factors of this response together
std::vector<FactorInfluence> screen_factors(ResponseSurface const& surface, double level = 0.05);

/// Holm's step-down adjustment: the k-th smallest of m times (m - k), never falling, at most 1.
/// NaN stays NaN and is not counted.
std::vector<double> adjust_holm(std::vector<double> const& p);

/// A factor over several responses.
struct OverallInfluence {
  std::string factor;
  double mean_share; ///< of its shares in the responses
  int n_influential; ///< responses on which it is influential
};

/// Sorted, the largest mean share first. All surfaces have the same factors; a response that does
/// not vary is left out.
/// @throws dem::InvalidInput if the factors differ or there is no surface
std::vector<OverallInfluence> screen_factors(std::vector<ResponseSurface> const& surfaces,
                                             double level = 0.05);

} // namespace coupling::study
