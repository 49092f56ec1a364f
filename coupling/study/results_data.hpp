#pragma once

#include "coupling/study/study_plan.hpp"
#include "coupling/study/study_quantities.hpp"

#include <vector>

namespace coupling::study {

/// The rows of `Design/Results`, one a run and in the runs' order: the row whose column `setup` is
/// the run's, whose column `replicate` (if there is one) is its replicate, and which the filter
/// lets pass.
/// @throws dem::InvalidInput for a run without a row or with two, a response that a row lacks, a
/// filter whose column is not there
std::vector<StudyValues> read_results(StudyPlan const& plan);

} // namespace coupling::study
