#include "coupling/record/press_record.hpp"

#include <algorithm>
#include <stdexcept>

namespace coupling {

void PressRecord::add_row(std::string stage, std::vector<double> values) {
  if (values.size() != columns_.size())
    throw std::invalid_argument("a row needs one value per column");
  stages_.push_back(std::move(stage));
  rows_.push_back(std::move(values));
}

bool PressRecord::has(std::string_view name) const {
  return std::ranges::any_of(columns_, [&](Column const& c) { return c.name == name; });
}

std::vector<double> PressRecord::column(std::string_view name) const {
  auto const found =
      std::ranges::find_if(columns_, [&](Column const& c) { return c.name == name; });
  if (found == columns_.end())
    throw std::out_of_range("the record has no column " + std::string(name));
  auto const k = static_cast<std::size_t>(found - columns_.begin());
  std::vector<double> values;
  values.reserve(rows_.size());
  for (auto const& row : rows_)
    values.push_back(row[k]);
  return values;
}

} // namespace coupling
