#pragma once

#include "coupling/study/study_page.hpp"

#include <string>

/// The parts of a study's page that are plain HTML and need no script. Everything from outside is
/// escaped here.
namespace coupling::study {

/// `25.095 kN`: a value of a response in the unit shown.
std::string shown_text(StudyPage const& page, std::string const& response, double value);

/// What the calibration says, a sentence each, in the units shown.
std::vector<std::string> calibration_answers(StudyPage const& page);

/// What was studied, and how many runs there are, in one paragraph.
std::string lead_html(StudyPage const& page);
/// How the runs stand, with class pass or fail; the failed ones with their reason.
std::string runs_verdict_html(StudyPage const& page);
std::string answers_html(StudyPage const& page);
/// Every run with its factors and responses, and what was published beside them.
std::string design_html(StudyPage const& page);
/// One card a response: coefficients, analysis of variance, how well the surface fits. The script
/// puts its plots into #surface-K.
std::string surfaces_html(StudyPage const& page);
std::string calibration_html(StudyPage const& page);
std::string trends_html(StudyPage const& page);
std::string cost_html(StudyPage const& page);
std::string validation_html(StudyPage const& page);
std::string study_provenance_html(StudyPage const& page);

} // namespace coupling::study
