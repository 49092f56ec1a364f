#pragma once

#include "coupling/study/batch_folder.hpp"
#include "coupling/study/study_plan.hpp"

#include <span>
#include <vector>

namespace coupling::study {

/// Makes runs beside the design at given values of the factors and keeps them in the folder, so
/// that a later call and load_study() know them. They are run by run_batch like any others.
/// @param natural  [SI], one a factor
/// @throws dem::InvalidInput for a value that the case refuses
std::vector<StudyRun> add_validation_runs(StudyPlan const& plan, BatchFolder const& folder,
                                          std::span<double const> natural, int replicates);

/// Those of earlier calls whose case is still what the study makes of their values.
std::vector<StudyRun> kept_validation_runs(StudyPlan const& plan, BatchFolder const& folder);

} // namespace coupling::study
