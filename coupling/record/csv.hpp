#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace coupling {

/// One line of a CSV file and where it stood.
struct CsvLine {
  std::size_t number;              ///< in the file, from 1
  std::vector<std::string> fields; ///< without quotes and surrounding blanks
};

/// Splits CSV text (RFC 4180: fields in double quotes may hold commas, and a doubled quote is one
/// quote). Empty lines and lines that start with # are left out; a byte order mark and carriage
/// returns are dropped.
/// @param name  of the file, for messages
/// @throws dem::InvalidInput  `name:line: ...` for a quote that does not close
std::vector<CsvLine> split_csv(std::string_view text, std::string const& name);

/// A field as CSV wants it: in quotes if it holds a comma, a quote, a # or a line break (which
/// becomes a blank).
std::string csv_field(std::string_view text);

/// The number in a field; `nan` and `inf` are numbers.
/// @throws dem::InvalidInput  `name:line: column = 'text': ...`
double csv_number(std::string const& text, std::string const& name, std::size_t line,
                  std::string const& column);

} // namespace coupling
