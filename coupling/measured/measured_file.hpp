#pragma once

#include "coupling/measured/lab_layout.hpp"
#include "coupling/measured/measured_data.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace coupling::measured {

/// A run as measured.json describes it; its series are yet to be read.
struct RunEntry {
  Run run;
  std::string where;         ///< `measured.json:12: runs[0]`
  bool has_file = true;      ///< false: single numbers alone are known, and run.file is a name
  std::string position_file; ///< empty: the gap is in the run's own file
  LabLayout layout;
  ClockChoice clock;
};

/// measured.json as values.
struct MeasuredFile {
  Sample sample;
  std::vector<Channel> channels;
  GapSource gap_source;
  std::vector<RunEntry> runs;
  std::vector<Decision> decisions; ///< of an earlier reading, which write_measured kept
};

/// @param name  of the file, for messages
/// @throws dem::InvalidInput  `name:line: entry = value: problem (why). Way out?` for whatever is
///         missing, unknown, out of range or contradicts itself
MeasuredFile parse_measured_file(std::string_view text, std::string const& name);

} // namespace coupling::measured
