#pragma once

#include "coupling/measured/lab_layout.hpp"
#include "coupling/measured/lab_text.hpp"
#include "coupling/quantity.hpp"

#include <map>
#include <string>
#include <vector>

namespace coupling::measured {

/// A column of a laboratory file that is read.
struct LabColumn {
  std::size_t field; ///< place in a row
  std::string name;  ///< as the header writes it
  std::string unit;  ///< as parse_quantity knows it
  Physical physical;
  bool is_travel = false; ///< gap = at_zero - travel
  double at_zero = 0.0;   ///< [m]
};

struct LabHeader {
  char delimiter;
  std::size_t n_fields;
  std::size_t first_row;                    ///< place in LabText::lines
  std::map<std::string, LabColumn> columns; ///< by channel, and `time`
  std::vector<std::string> remarks;
};

/// Finds the header line: of the first 200 lines, parted by comma, semicolon or tab, the one with
/// most names that are known (or named in `layout`); then the units, in the header or in the line
/// below it.
/// @param needed  channels, and `time`, that the file must have
/// @throws dem::InvalidInput  `name:line: ...` for no header, a needed column that is missing, two
///         columns of one meaning, a column without unit or with the wrong one, a travel without
///         its zero
LabHeader find_lab_header(LabText const& text, std::string const& name, LabLayout const& layout,
                          std::vector<std::string> const& needed);

} // namespace coupling::measured
