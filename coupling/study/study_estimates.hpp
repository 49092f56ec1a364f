#pragma once

#include "coupling/study/batch_folder.hpp"

#include <vector>

namespace coupling::study {

/// What each run is expected to need: as an earlier call found for the same case, else by building
/// its press. The time of a particle-step is that of the folder's finished runs, if there are any.
/// @throws dem::InvalidInput for a case whose press cannot be built
std::vector<RunEstimate> estimate_runs(std::vector<StudyRun> const& runs,
                                       BatchFolder const& folder);

} // namespace coupling::study
