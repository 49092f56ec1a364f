#pragma once

#include "coupling/study/box_minimum.hpp"

namespace coupling::study {

/// An interval in coded units and whether it ends at the box.
struct ProfileInterval {
  double low, high;
  bool is_open_low, is_open_high;
};

/// All values v of one unknown at which the least sum of squares over the others stays below
/// best.value + rise: from outside inwards in 32 steps a side, then bisected to 1e-8 of the width.
/// A region in several parts is given from its first to its last point.
ProfileInterval profile_interval(ResidualsAt const& residuals, Box const& box,
                                 BoxMinimum const& best, int unknown, double rise);

} // namespace coupling::study
