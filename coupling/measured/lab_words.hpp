#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The words of laboratories: what their files call columns and units.
namespace coupling::measured {

/// A column's name and unit as its header writes them: `Kraft [kN]`, `Force (N)`, `Weg / mm`,
/// `tiempo en s`.
struct ColumnHeader {
  std::string name;
  std::string unit; ///< empty: none
};

ColumnHeader parse_column_header(std::string_view field);

/// `time`, `travel`, or a channel's name, for its own name and those that laboratories give it in
/// English, German and Spanish; empty for any other.
std::string recognised_column(std::string_view name);

/// All names that are recognised, for suggestions.
std::vector<std::string> const& recognised_names();

/// The unit's symbol as case files know it: `sec` and `Sek.` are s, `N/mm²` is MPa, `KN` is kN. As
/// written where it has no other spelling.
std::string unit_symbol(std::string_view written);

} // namespace coupling::measured
