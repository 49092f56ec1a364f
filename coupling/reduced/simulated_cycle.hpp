#pragma once

#include "coupling/case.hpp"
#include "coupling/record/press_record.hpp"
#include "coupling/reduced/bed_law.hpp"

#include <cstddef>
#include <vector>

namespace coupling::reduced {

/// What a simulation recorded of one press cycle, a value a record, in order of time.
struct SimulatedCycle {
  std::vector<double> height;          ///< between the punch faces as they are [m]
  std::vector<double> upper, lower;    ///< forces on the punches [N], positive in compression
  std::vector<double> radial_pressure; ///< mean over the bed's height [Pa]
};

/// The columns of a run's curves.csv; every stage, since `parts_of` finds loading and unloading.
/// @throws dem::InvalidInput if a column is missing
SimulatedCycle cycle_of(PressRecord const& record);

/// The bed that a case presses.
Bed bed_of(Case const& setup);

/// Records of a cycle by what the bed goes through. First loading: the height is smaller than ever
/// before, and the bed bears. Unloading: after the smallest height, larger than ever since. What is
/// neither (dwell, reloading, a machine that shakes, a released die, ejection) is left out.
struct CycleParts {
  std::vector<std::size_t> loading, unloading;
  std::size_t turn = 0;      ///< the record of the smallest height, last of `loading`
  double largest_mean = 0.0; ///< largest mean of both forces in first loading [N]
};

/// @throws dem::InvalidInput  with record and value, for numbers that no press gives: lengths that
/// differ, heights that are not positive, no contact, a force that does not rise
CycleParts parts_of(SimulatedCycle const& cycle);

} // namespace coupling::reduced
