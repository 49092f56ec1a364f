#pragma once

#include "coupling/measured/lab_text.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

/// Numbers as laboratories write them: decimal point or comma, thousands in groups.
namespace coupling::measured {

/// What a cell says about the decimal mark of its file.
enum class MarkEvidence {
  none,            ///< 12, or no number
  point,           ///< 1.5, 1,234.5, 1,234,567
  comma,           ///< 1,5, 1.234,5, 1.234.567
  ambiguous_point, ///< 1.234 is 1.234 or 1234
  ambiguous_comma  ///< 1,234 likewise
};

MarkEvidence mark_evidence(std::string_view cell);

/// The number as 1234.5e-6, or nothing if the cell is no number. Groups of three digits may be
/// parted by blanks, apostrophes, or the mark that is not the decimal one.
/// @param mark  '.' or ','
std::optional<std::string> plain_number(std::string_view cell, char mark);

/// Nothing was read: empty, nan, NA, N/A, - or --.
bool is_gap(std::string_view cell);

} // namespace coupling::measured
