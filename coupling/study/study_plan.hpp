#pragma once

#include "coupling/study/study_file.hpp"

#include <span>
#include <string>
#include <vector>

namespace coupling::study {

/// One run of a study: a case, and where it stands in the design.
struct StudyRun {
  std::string id;    ///< name of its folder: E1375_CED3, E1375_CED3_r2 for the second packing
  std::string setup; ///< the point: row of the table, or factors with their values
  std::string where; ///< `settings.csv:7`, `study.prm:12`
  int replicate = 1; ///< from 1; the packing seed is the case's + replicate - 1
  bool is_validation = false;  ///< beside the design
  std::vector<double> natural; ///< [SI], of each factor
  std::string case_text = {};  ///< the full case as understood
  std::string hash = {};       ///< of case_text, 16 hexadecimal digits
};

/// A study with its runs. Factors whose limits a table leaves open have them.
struct StudyPlan {
  StudyFile study;
  std::vector<StudyRun> runs;
};

/// Every run of the design with its case, read and checked as far as a case can be without
/// building it.
/// @throws dem::InvalidInput for a value that the case refuses, a factor without a column or
/// constant, two runs with one name, replicates that could not differ
StudyPlan plan_study(StudyFile study);

/// Runs beside the design, at given values of the factors: `replicates` packings named
/// `LABEL_E2230_CED7`, `LABEL_E2230_CED7_r2`, ...
/// @param label    "validation"
/// @param natural  [SI], one a factor
/// @throws dem::InvalidInput for a value that the case refuses, or a table's study without factors
std::vector<StudyRun> runs_at(StudyPlan const& plan, std::string const& label,
                              std::span<double const> natural, int replicates);

/// 16 hexadecimal digits that tell two texts apart.
std::string hash_of(std::string_view text);

} // namespace coupling::study
