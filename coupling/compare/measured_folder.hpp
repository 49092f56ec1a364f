#pragma once

#include "coupling/compare/source.hpp"

#include <filesystem>
#include <vector>

namespace coupling {

/// The runs of a folder of measured data: each its CSV and its `scalars`.
/// @throws dem::InvalidInput  naming the file and the entry that is missing or wrong
std::vector<Source> read_measured_folder(std::filesystem::path const& folder);

} // namespace coupling
