#pragma once

#include "coupling/study/study_file.hpp"

#include <filesystem>
#include <string>

namespace coupling::study {

/// What a study wants to know beside its surfaces: `Calibration`, `Extrapolation`, `Cost` and
/// `Reference` of its file, into `study`, whose factors and responses are read already.
/// @throws dem::InvalidInput  `file:line: entry = value: problem (why). Way out?`
void read_aims(StudyText const& text, StudyFile& study);

/// The file `written` in an entry, seen from the study file, absolute; empty where it is empty.
/// @throws dem::InvalidInput if there is none
std::filesystem::path file_of(StudyText const& text, std::filesystem::path const& study,
                              std::string const& path, std::string const& written);

} // namespace coupling::study
