#pragma once

#include "coupling/study/results_table.hpp"

#include <string>

namespace coupling::study {

/// study.json: design, factors, responses, runs with status and folder, cost. Keys that an analysis
/// adds are none of ours.
std::string study_json(ResultsTable const& table);

} // namespace coupling::study
