#pragma once

#include "coupling/case_text.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace coupling {

/// A row of a table of set-ups.
struct NamedSetup {
  std::string name;
  std::string where; ///< `settings.csv:7`
  std::vector<PlacedValue> values;
};

/// All rows of such a table, as described below.
/// @throws dem::InvalidInput  for a table that cannot be read
std::vector<NamedSetup> read_setups(std::filesystem::path const& table);

/// The row of that name. @param table  for the message
/// @throws dem::InvalidInput  for a name that is not there, with the nearest ones
NamedSetup const& find_setup(std::vector<NamedSetup> const& setups, std::string_view name,
                             std::filesystem::path const& table);

/// The overrides ("Section/Entry=value") of one row of `settings.csv` beside a case, for `--setup
/// NAME`.
///
/// The first column is `setup`; every other header is an entry's path, or several joined by `+`
/// that share the value; a header in brackets is a remark and sets nothing. Lines that begin with
/// `#` are comments; a cell that holds commas stands in double quotes; an empty cell leaves the
/// entry as the case has it.
/// @throws dem::InvalidInput  for a table that cannot be read, or a name that is not in it, with
/// the nearest ones
std::vector<std::string> setup_overrides(std::filesystem::path const& case_file,
                                         std::string_view setup_name);

/// All names of that table, in its order.
std::vector<std::string> setup_names(std::filesystem::path const& case_file);

} // namespace coupling
