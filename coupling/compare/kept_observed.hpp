#pragma once

#include "coupling/report/report.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Published or measured values that travel with a run, so that its report can set them beside its
/// own wherever the run folder goes.
namespace coupling {

struct ObservedTable {
  std::filesystem::path name; ///< of the file
  std::string text;           ///< CSV
};

/// The rows that name `setup` in the tables in `observed/` beside the case. Tables without a column
/// `setup`, or without such a row, are left out.
/// @throws dem::InvalidInput for a table that cannot be read
std::vector<ObservedTable> observed_rows(std::filesystem::path const& case_file,
                                         std::string const& setup);

/// Writes them to `observed/` in the run folder.
void keep_observed(std::vector<ObservedTable> const& tables,
                   std::filesystem::path const& run_folder);

/// What keep_observed() left there, by the names of the tables.
/// @throws dem::InvalidInput for a table that cannot be read
std::vector<ObservedValue> kept_observed(std::filesystem::path const& run_folder);

} // namespace coupling
