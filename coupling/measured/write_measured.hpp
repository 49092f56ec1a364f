#pragma once

#include "coupling/measured/measured_data.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace coupling::measured {

/// The canonical form: SI units, one CSV a run, numbers in the fewest digits that read back to the
/// same bits. Names of runs that do not end in .csv get it.
/// @return  texts by file name; the description is `measured.json`
std::map<std::string, std::string> print_measured(MeasuredData const& data);

/// Writes the canonical form into a folder, which is made if it is not there; measured.json last,
/// so that a folder that has one is whole. read_measured reads the same values, to the bit.
/// @throws dem::InvalidInput, WriteFailed
void write_measured(MeasuredData const& data, std::filesystem::path const& folder);

} // namespace coupling::measured
