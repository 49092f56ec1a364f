#pragma once

#include "coupling/case.hpp"

#include <filesystem>

namespace coupling {

/// A gap measured over time: CSV with the columns `time [unit]` and `punch_gap [unit]`, whatever
/// else it has. Rows where one of the two is `nan` are left out.
/// @param time_scale  simulated time over measured time
/// @throws dem::InvalidInput  naming file and row: a column that is missing, fewer than two rows, a
/// time that does not increase, a gap that is not above 0
GapPath read_gap_path(std::filesystem::path const& file, double time_scale);

/// How far the punches may stand from where a path begins [m]: the digits of a laboratory's file.
inline constexpr double path_start_tolerance = 1e-6;

/// The gap at a time [m], straight between the points and constant beyond the last.
double gap_at(GapPath const& path, double time);

} // namespace coupling
