#pragma once

#include "coupling/diagnosis/fit.hpp"

namespace coupling::diagnosis {

/// Sizes of one cause that the data allow.
struct SizeInterval {
  double value;                   ///< of the greatest likelihood [unit]
  double low, high;               ///< [unit]
  bool is_open_low, is_open_high; ///< ends at a bound or at `widest`: not identified on that side
};

/// Profile likelihood: all a with  least objective at a fixed - least objective <= rise S,  the
/// objective without the prior of this size (those of other unknowns stay, flat for other sizes).
/// @param fit      the hypothesis, at its best
/// @param tempering  S of the selection
/// @param rise     3.84 for 95 %
/// @param widest   where the search for an end gives up, in prior scales
/// Source: Raue et al., Bioinformatics 25 (2009) 1923.
/// @throws dem::InvalidInput if the mechanism is not active
SizeInterval size_interval(Comparison const& comparison, Fit const& fit, int mechanism,
                           double tempering, double rise = 3.84, double widest = 20.0);

} // namespace coupling::diagnosis
