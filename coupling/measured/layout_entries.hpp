#pragma once

#include "coupling/measured/lab_layout.hpp"
#include "coupling/measured/placed_json.hpp"

#include <string>
#include <vector>

namespace coupling::measured {

/// Entries that may stand in a run or, for all runs, at the top: columns, decimal_mark, clock.
std::vector<std::string> const& layout_entries();

/// Reads those entries of an object over what already holds.
void read_layout(PlacedJson const& object, LabLayout& layout, ClockChoice& clock);

} // namespace coupling::measured
