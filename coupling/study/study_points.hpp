#pragma once

#include "coupling/study/study_file.hpp"

#include <span>
#include <string>
#include <vector>

namespace coupling::study {

/// A setting of all factors, and what it sets in the case.
struct StudyPoint {
  std::string name;                ///< row of the table, or factors with their values
  std::string where;               ///< `settings.csv:7`, `study.prm:12`
  std::vector<double> natural;     ///< [SI], of each factor
  std::vector<PlacedValue> values; ///< entries of the case
  int times = 1;                   ///< how often the design holds it
};

/// The points of a study's design, each once. Limits that a table's factors leave open are set.
/// @throws dem::InvalidInput
std::vector<StudyPoint> points_of(StudyFile& study);

/// A point at given values [SI].
StudyPoint point_at(StudyFile const& study, std::span<double const> natural);

} // namespace coupling::study
