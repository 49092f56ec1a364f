#pragma once

#include "coupling/compare/source.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace coupling {

/// A row of a table of single values.
struct ValueRow {
  std::string setup; ///< empty if the table has no such column
  ObservedValue value;
};

/// Whether a CSV text is such a table, by its first line.
bool is_value_table(std::string const& text);

/// @throws dem::InvalidInput  `file:line: ...`
std::vector<ValueRow> read_value_table(std::filesystem::path const& file);

/// The numbers of a summary under the names that the comparison uses; without those the run did not
/// reach.
std::map<std::string, SourceValue> values_of(Summary const& summary);

} // namespace coupling
