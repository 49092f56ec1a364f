#include "coupling/measured/measured_data.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace coupling::measured {

Channel const* MeasuredData::channel(std::string_view name) const {
  auto const found = std::ranges::find(channels, name, &Channel::name);
  return found == channels.end() ? nullptr : &*found;
}

bool MeasuredData::has_numbers_alone() const {
  return std::ranges::none_of(runs, &Run::has_curve);
}

std::vector<std::vector<std::size_t>> repeats(MeasuredData const& data) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t k = 0; k < data.runs.size(); ++k) {
    auto const same = std::ranges::find_if(groups, [&](auto const& group) {
      return data.runs[group.front()].press == data.runs[k].press;
    });
    if (same == groups.end())
      groups.push_back({k});
    else
      same->push_back(k);
  }
  return groups;
}

std::string in_words(Decision const& decision) {
  if (decision.file.empty())
    return decision.what;
  return decision.row == 0 ? fmt::format("{}: {}", decision.file, decision.what)
                           : fmt::format("{}:{}: {}", decision.file, decision.row, decision.what);
}

} // namespace coupling::measured
