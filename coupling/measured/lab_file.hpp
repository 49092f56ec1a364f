#pragma once

#include "coupling/measured/lab_layout.hpp"
#include "coupling/measured/measured_data.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace coupling::measured {

/// The table of a laboratory file in SI units.
struct LabTable {
  std::vector<double> time = {};                          ///< [s]; of the file's clock
  std::map<std::string, std::vector<double>> series = {}; ///< by channel [SI]; NaN = gap
  std::vector<std::size_t> rows = {};                     ///< line of the file
  std::map<std::string, double> unit_factors = {};        ///< SI per written unit, by channel
  std::size_t n_corrupt = 0;                              ///< rows left out
  std::vector<Decision> decisions = {};

  std::size_t size() const { return rows.size(); }
};

/// Reads a table of text: comma, semicolon or tab between fields; decimal point or comma;
/// thousands in groups; lines before the header; names and units in English, German and Spanish;
/// UTF-8 or Latin-1; # for remarks. Rows that are corrupt (fields missing or too many, no number,
/// no time) are left out and named.
/// @param path    for messages
/// @param file    as decisions name it
/// @param needed  channels, and `time`, that it must have
/// @throws dem::InvalidInput  `path:line: ...` for no header, units missing or wrong, a decimal
/// mark
///         that cannot be told from thousands, more than limits::corrupt_share of corrupt rows, no
///         rows
LabTable parse_lab_table(std::string_view bytes, std::string const& path, std::string const& file,
                         LabLayout const& layout, std::vector<std::string> const& needed);

/// parse_lab_table of a file with time, gap and upper punch force.
LabTable read_lab_file(std::filesystem::path const& file, LabLayout const& layout = {});

} // namespace coupling::measured
