#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Bytes of a laboratory file to lines of UTF-8.
namespace coupling::measured {

struct TextLine {
  std::size_t number; ///< in the file, from 1
  std::string text;   ///< without line end
};

struct LabText {
  std::vector<TextLine> lines;      ///< without blank ones
  std::vector<std::string> remarks; ///< what was done to the bytes
};

/// Reads UTF-8 with or without byte order mark; what is not UTF-8 is taken for Latin-1. Lines end
/// with \n, \r\n or, where there is no \n, with \r.
/// @throws dem::InvalidInput  for an empty file, UTF-16, bytes that are no text
LabText parse_lab_text(std::string_view bytes, std::string const& name);

/// A row's fields without quotes and surrounding blanks. A quote that does not close ends with
/// the row.
std::vector<std::string> split_fields(std::string_view line, char delimiter);

/// Lower case, letters without accents, and single blanks for `_`, `-` and `.`: how names are
/// compared.
std::string folded(std::string_view name);

} // namespace coupling::measured
