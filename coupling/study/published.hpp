#pragma once

#include "coupling/study/study_plan.hpp"
#include "coupling/study/study_quantities.hpp"

#include <map>
#include <string>
#include <vector>

namespace coupling::study {

/// Published values that a study's runs can be set beside, from its `Reference/Tables`.
class Published {
public:
  /// @throws dem::InvalidInput for a table that cannot be read or has no column `setup`, and where
  /// `Reference/Rows` names a set-up or row that is not there
  explicit Published(StudyPlan const& plan);

  /// Who published, by the text columns beside `setup`: EDEM, LIGGGHTS; the table's name where
  /// there are none. In the tables' order.
  std::vector<std::string> const& sources() const { return sources_; }

  /// Times the response's `Reference scale`; NaN where the source has no such number of the set-up.
  /// Of two rows of a source the first counts.  [SI]
  double value(std::string const& source, std::string const& setup,
               StudyResponse const& response) const;

private:
  void read(std::filesystem::path const& table);

  ReferencePlan plan_;
  std::vector<std::string> sources_;
  std::map<std::string, std::map<std::string, StudyValues>> values_; // source, row
};

} // namespace coupling::study
