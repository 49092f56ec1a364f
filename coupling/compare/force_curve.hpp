#pragma once

#include "coupling/record/press_record.hpp"

#include <optional>
#include <vector>

/// Force over gap, taken apart at the smallest gap.
namespace coupling {

/// A monotonic part of the force over the gap, sorted by gap.
struct ForceBranch {
  std::vector<double> gap;   ///< [m], strictly increasing
  std::vector<double> force; ///< [N]
};

/// Both ways of a press cycle and the work along them. Rows where the gap or the force is not a
/// number are left out.
struct ForceCurve {
  ForceBranch
      loading; ///< each row that closes the gap further than any before, to the smallest gap
  ForceBranch unloading; ///< from there each row that opens it further
  double
      loading_work; ///< - integral of F dgap to the smallest gap [J], trapezoidal, along every row
  double unloading_work; ///< + integral of F dgap after it [J]: what the bed gives back
  double smallest_gap;   ///< [m]
  double peak;           ///< [N]
};

/// @returns nothing if the record lacks `punch_gap` or `upper_punch_force`, or has fewer than two
/// rows with both
std::optional<ForceCurve> force_curve(PressRecord const& record);

/// Largest and root mean square difference of two branches, on a common grid of gaps between which
/// both are known, as far as one of them carries at least a thousandth of `peak`; relative to
/// `peak`.
struct BranchDifference {
  double largest; ///< [1], of the peak
  double at_gap;  ///< [m], where
  double rms;     ///< [1], of the peak
};

/// @returns nothing if the two have no gaps in common
std::optional<BranchDifference> difference(ForceBranch const& reference, ForceBranch const& other,
                                           double peak);

} // namespace coupling
