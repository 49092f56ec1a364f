#pragma once

#include "coupling/study/study_file.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace coupling::study {

/// A number of a run or of a row of results.
struct StudyValue {
  double value;     ///< [SI]; NaN where it is not known
  std::string unit; ///< SI; `1` for a ratio
};

/// By name without unit: max_force, porosity, compact_height, ...
using StudyValues = std::map<std::string, StudyValue>;

/// Every number of a summary.json, by its key without the unit: `max_force_N` is max_force [N].
/// @throws dem::InvalidInput if it cannot be read
StudyValues values_of_summary(std::filesystem::path const& file);

/// The responses of a study file. Their quantities are keys of summary.json (with or without the
/// unit at the end) or, if the study reads results, columns of that table.
/// @throws dem::InvalidInput
std::vector<StudyResponse> read_responses(StudyText const& text, StudyFile const& study);

} // namespace coupling::study
