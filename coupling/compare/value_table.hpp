#pragma once

#include "coupling/compare/source.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace coupling {

/// A row of a table of single values.
struct ValueRow {
  std::string setup; ///< text of the column `setup`; empty if there is none
  std::string label; ///< all text columns, "E0250_CED1_D300 LIGGGHTS"
  std::vector<ObservedValue> values;
};

/// Whether CSV text is such a table and no curve: a curve has a time or a gap.
bool is_value_table(std::string const& text, std::string const& name);

/// @throws dem::InvalidInput  `file:line: ...`
std::vector<ValueRow> read_value_table(std::filesystem::path const& file);

/// The numbers of a summary under the names that the comparison uses; without those the run did not
/// reach.
std::map<std::string, SourceValue> values_of(Summary const& summary);

} // namespace coupling
