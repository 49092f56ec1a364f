#pragma once

#include "coupling/measured/measured_file.hpp"
#include "coupling/measured/read_measured.hpp"

#include <string>

namespace coupling::measured {

/// Reads the series of a run out of its file, or of its files of forces and positions; cleans and
/// checks them; adds what was decided to `data.decisions`.
/// @param data    sample, channels and gap source
/// @param folder  put before names in messages
Run read_run_series(RunEntry const& entry, std::string const& folder, FileText const& text_of,
                    MeasuredData& data);

/// A run without a file: its numbers, checked.
Run read_run_numbers(RunEntry const& entry, MeasuredData const& data);

} // namespace coupling::measured
