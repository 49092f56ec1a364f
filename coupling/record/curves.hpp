#pragma once

#include "coupling/record/press_record.hpp"

#include <filesystem>
#include <string>

namespace coupling {

/// Writes the time series: header `name [unit]` and one column `stage` in second place; numbers in
/// the fewest digits that read back to the same bits.
/// @throws dem::InvalidInput, WriteFailed
void write_curves(std::filesystem::path const& file, PressRecord const& record);

/// Reads what write_curves wrote, and observed data of the same form: columns in any order, each
/// `name [unit]`, a `stage` if there is one (else the stages are empty), `nan` for a value that was
/// not measured, # for remarks.
/// @throws dem::InvalidInput  `file:line: ...` for a column without unit or named twice, a row that
/// is too short or
///         long, a field that is no number, a file without rows
PressRecord read_curves(std::filesystem::path const& file);
PressRecord parse_curves(std::string const& text, std::string const& name);

/// The first part of a record: rows up to and including `time` [s] of its column `time`. For
/// resuming a run.
PressRecord until(PressRecord const& record, double time);

} // namespace coupling
