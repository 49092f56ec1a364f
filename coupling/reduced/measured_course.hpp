#pragma once

#include "coupling/measured/measured_data.hpp"
#include "coupling/reduced/gap_course.hpp"

namespace coupling::reduced {

/// What the gap did in a run: as few straight parts as its readings follow within their noise, and
/// corners where closing and opening meet the gap that is held, or each other without a dwell.
/// @throws dem::InvalidInput if the gap never closes by more than its noise
GapCourse measured_course(measured::MeasuredData const& data, measured::Run const& run);

} // namespace coupling::reduced
