#pragma once

#include <string>
#include <string_view>

namespace coupling {

/// Without blanks, tabs and the returns of Windows' line ends at either end.
inline std::string trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  auto const first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos)
    return {};
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

} // namespace coupling
