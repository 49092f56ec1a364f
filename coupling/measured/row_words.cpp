#include "coupling/measured/row_words.hpp"

#include <fmt/format.h>

#include <vector>

namespace coupling::measured {

std::string rows_in_words(std::span<std::size_t const> rows) {
  constexpr std::size_t most_parts = 12;
  std::vector<std::string> parts;
  std::size_t k = 0;
  while (k < rows.size() && parts.size() < most_parts) {
    std::size_t const first = k++;
    while (k < rows.size() && rows[k] == rows[k - 1] + 1)
      ++k;
    std::size_t const n = k - first;
    parts.push_back(n == 1   ? fmt::format("{}", rows[first])
                    : n == 2 ? fmt::format("{} and {}", rows[first], rows[k - 1])
                             : fmt::format("{} to {}", rows[first], rows[k - 1]));
  }
  if (k < rows.size())
    parts.push_back(fmt::format("{} more", rows.size() - k));
  std::string words = rows.size() == 1 ? "row " : "rows ";
  for (std::size_t p = 0; p < parts.size(); ++p)
    words += (p == 0 ? "" : p + 1 == parts.size() ? " and " : ", ") + parts[p];
  return words;
}

} // namespace coupling::measured
