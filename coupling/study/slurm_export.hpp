#pragma once

#include "coupling/study/batch_folder.hpp"

#include <filesystem>
#include <vector>

namespace coupling::study {

struct SlurmChoice {
  std::filesystem::path program; ///< presscheck
  std::filesystem::path study;   ///< study file
  int threads = 1;               ///< of each run
};

/// Writes `slurm/array.sh` (one task a run), `slurm/collect.sh` and `slurm/submit.sh`, which
/// submits both. Account, partition and time are variables of submit.sh; time and memory are filled
/// in from the estimates.
/// @returns submit.sh
std::filesystem::path export_slurm(BatchFolder const& folder, std::vector<StudyRun> const& runs,
                                   std::vector<RunEstimate> const& estimates,
                                   SlurmChoice const& choice);

} // namespace coupling::study
