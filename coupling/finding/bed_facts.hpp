#pragma once

#include "coupling/finding/entry_change.hpp"

#include <filesystem>

namespace coupling::finding {

/// What a run folder says of its bed at the largest force on the upper punch, from curves.csv,
/// case.resolved.prm and the grains of run.h5 (without them the overlap is not known). The growth
/// of the force is that of its last fifth.
/// @throws dem::InvalidInput if the curves or the case are missing
BedFacts bed_facts(std::filesystem::path const& run_folder);

} // namespace coupling::finding
