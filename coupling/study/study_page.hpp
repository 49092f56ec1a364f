#pragma once

#include "coupling/study/analysis.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace coupling::study {

/// What a study's page shows. Without an analysis (runs are missing, or the study has no response)
/// it lists the runs.
struct StudyPage {
  ResultsTable const& table;
  StudyPlan const& plan;
  std::optional<Analysis> const& analysis;
};

/// report.html of a study: one file that needs a browser and nothing else.
/// @throws dem::InvalidInput for a table of published values or a run's file that cannot be read;
///         WriteFailed
void write_study_page(StudyPage const& page, std::filesystem::path const& file);

/// The main answers, a sentence each: what was calibrated, contradictions, what matters, what the
/// extrapolation and the cost say, how the validation went.
std::vector<std::string> answers(StudyPage const& page);

/// What the page's script draws, as JSON text: factors and responses in the units shown.
std::string study_page_json(StudyPage const& page);

} // namespace coupling::study
