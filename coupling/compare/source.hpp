#pragma once

#include "coupling/record/press_record.hpp"
#include "coupling/report/report.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace coupling {

/// A single number of a source with its standard uncertainty.
struct SourceValue {
  double value;    ///< SI
  double sd = 0.0; ///< SI; 0 = not stated
};

/// Something that can be compared: a run, a curve, or what somebody measured or published.
struct Source {
  std::string label;
  PressRecord record{{}};                    ///< SI; no columns if there is no curve
  std::map<std::string, SourceValue> values; ///< by name: max_force, porosity, compact_height, ...
};

/// Reads what a path holds:
///  - a run folder (curves.csv and, if the run got so far, summary.json): one source
///  - a folder of measured data (measured.json and its CSV files): one source a run
///  - a curves file, header `name [unit]`, in any units of the right dimension, `nan` allowed: one
///  source
///  - a table of single values (below): one source a row; `table.csv:NAME` takes the rows of setup
///  NAME
/// @throws dem::InvalidInput  for anything else, and for what those files hold that cannot be read
std::vector<Source> read_sources(std::filesystem::path const& path);

/// A table of single values: CSV with columns `name [unit]` (`max_force [N]`, `porosity [%]`),
/// their standard uncertainties if known (`max_force_sd [N]`), and columns of words without a unit
/// (`setup`, `simulator`). Empty fields and `nan` are left out; values become SI.
/// @param setup  only rows of this set-up, and rows that name none; empty = all
/// @throws dem::InvalidInput  `file:line: ...`
std::vector<ObservedValue> read_observed_values(std::filesystem::path const& file,
                                                std::string const& setup = "");

/// Ours beside theirs, for those observed values that the summary has.
std::vector<ComparedValue> beside_observed(Summary const& ours,
                                           std::vector<ObservedValue> const& theirs);

} // namespace coupling
