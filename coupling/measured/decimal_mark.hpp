#pragma once

#include "coupling/measured/lab_header.hpp"
#include "coupling/measured/lab_text.hpp"

#include <span>
#include <string>
#include <vector>

namespace coupling::measured {

/// A row of a laboratory file, split.
struct LabRow {
  std::size_t number; ///< line of the file
  std::vector<std::string> fields;
};

/// The mark that the numbers of a file use, '.' or ','. A few cells that say otherwise are corrupt
/// and do not count.
/// @throws dem::InvalidInput  where every number could be decimal or in thousands, or both marks
///         occur
char decimal_mark_of(std::span<LabRow const> rows, LabHeader const& header,
                     std::string const& path);

} // namespace coupling::measured
