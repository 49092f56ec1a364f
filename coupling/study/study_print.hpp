#pragma once

#include "coupling/study/study_file.hpp"

#include <string>

namespace coupling::study {

/// The study as understood: every entry that was written, paths absolute, so that it can be read
/// from anywhere.
std::string print_study(StudyText const& text, StudyFile const& study);

} // namespace coupling::study
