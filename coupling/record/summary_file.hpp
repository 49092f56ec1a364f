#pragma once

#include "coupling/record/press_record.hpp"

#include <filesystem>
#include <string>

namespace coupling {

/// The keys of summary.json with their unit in the name (`max_force_N`). A value that the run did
/// not reach or a tool does not know is null.
std::string summary_json(Summary const& summary);

/// @throws dem::InvalidInput, WriteFailed
void write_summary(std::filesystem::path const& file, Summary const& summary);

/// @throws dem::InvalidInput if it is no JSON, a key is missing, or a value has the wrong type
Summary read_summary(std::filesystem::path const& file);

} // namespace coupling
