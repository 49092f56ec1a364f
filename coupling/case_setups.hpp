#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace coupling {

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
