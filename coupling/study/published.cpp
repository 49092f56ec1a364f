#include "coupling/study/published.hpp"

#include "coupling/compare/value_table.hpp"
#include "coupling/nearest_name.hpp"
#include "coupling/quote.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace coupling::study {
namespace {

/// "LIGGGHTS" of "E0250_CED1_D300 LIGGGHTS".
std::string source_of(ValueRow const& row, std::string const& table) {
  std::string words;
  for (auto const& word : split_list(row.label, ' '))
    if (word != row.setup)
      words += (words.empty() ? "" : " ") + word;
  return words.empty() ? table : words;
}

void check_rows(StudyPlan const& plan, std::vector<std::string> const& rows) {
  std::vector<std::string> setups;
  for (auto const& run : plan.runs)
    setups.push_back(run.setup);
  auto const check = [&](std::string const& name, std::vector<std::string> const& known,
                         std::string_view what) {
    if (std::ranges::count(known, name) == 0)
      plan.study.text.refuse("Reference/Rows",
                             fmt::format("'{}' is no {}.{}", quote(name), what,
                                         did_you_mean(name, known, "Which one is meant?")));
  };
  for (auto const& [setup, row] : plan.study.references.rows) {
    check(setup, setups, "set-up of this study");
    check(row, rows, "row of the tables");
  }
}

} // namespace

Published::Published(StudyPlan const& plan) : plan_(plan.study.references) {
  for (auto const& table : plan_.tables)
    read(table);
  std::vector<std::string> rows;
  for (auto const& [source, of] : values_)
    for (auto const& [row, values] : of)
      rows.push_back(row);
  check_rows(plan, rows);
}

void Published::read(std::filesystem::path const& table) {
  for (auto const& row : read_value_table(table)) {
    VALIDATE(!row.setup.empty(),
             fmt::format("{}: has a row without a set-up (published values are matched by the "
                         "column 'setup'). Add it?",
                         table.string()));
    auto const source = source_of(row, table.stem().string());
    if (std::ranges::count(sources_, source) == 0)
      sources_.push_back(source);
    auto const [place, is_new] = values_[source].try_emplace(row.setup);
    if (!is_new)
      continue;
    for (auto const& value : row.values)
      place->second[value.name] = {value.value, value.unit};
  }
}

double Published::value(std::string const& source, std::string const& setup,
                        StudyResponse const& response) const {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  auto const renamed = plan_.rows.find(setup);
  auto const of = values_.find(source);
  if (of == values_.end())
    return unknown;
  auto const row = of->second.find(renamed == plan_.rows.end() ? setup : renamed->second);
  if (row == of->second.end())
    return unknown;
  auto const found = row->second.find(response.quantity);
  if (found == row->second.end() || found->second.unit != response.unit)
    return unknown;
  return response.reference_scale * found->second.value;
}

} // namespace coupling::study
