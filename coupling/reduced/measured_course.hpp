#pragma once

#include "coupling/measured/measured_data.hpp"
#include "coupling/reduced/gap_course.hpp"

namespace coupling::reduced {

/// What the gap did in a run: means of its readings, joined by straight lines, and corners where
/// the straight ends of closing and opening meet the lowest gap, or each other without a dwell.
/// @throws dem::InvalidInput if the gap never closes by more than its noise
GapCourse measured_course(measured::MeasuredData const& data, measured::Run const& run);

} // namespace coupling::reduced
