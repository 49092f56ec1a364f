#include "coupling/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace coupling {

namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

} // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      std::size_t const replaced = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

std::string nearest_name(std::string_view written, std::span<std::string const> names) {
  // A name is never hundreds of letters long; a distance to such a text costs time and says
  // nothing.
  if (written.size() > 200)
    return "";
  std::string nearest;
  std::size_t least = (written.size() <= 3 ? 1 : std::max<std::size_t>(2, written.size() / 3)) + 1;
  for (std::string const& name : names) {
    std::size_t const distance = edit_distance(written, name);
    if (distance < least) {
      least = distance;
      nearest = name;
    }
  }
  return nearest;
}

std::string did_you_mean(std::string_view written, std::span<std::string const> names,
                         std::string_view otherwise) {
  std::string const nearest = nearest_name(written, names);
  return nearest.empty() ? fmt::format(" {}", otherwise)
                         : fmt::format(" Did you mean '{}'?", nearest);
}

} // namespace coupling
