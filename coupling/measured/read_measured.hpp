#pragma once

#include "coupling/measured/measured_data.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace coupling::measured {

/// Reads a folder with measured.json and the files of its runs (coupling/measured/README.md has the
/// form). What was left out, assumed or could not be checked is in `decisions`.
/// @throws dem::InvalidInput  `file:line: entry = value: problem (why). Way out?` for data that
///         cannot be read, have no uncertainty, go backwards in time or contradict themselves
MeasuredData read_measured(std::filesystem::path const& folder);

/// Text of the file of that name, relative to the folder.
using FileText = std::function<std::string(std::string const& file)>;

/// read_measured of texts instead of files.
/// @param json    text of measured.json
/// @param folder  put before names in messages, with its slash; may be empty
MeasuredData parse_measured(std::string_view json, std::string const& folder,
                            FileText const& text_of);

} // namespace coupling::measured
