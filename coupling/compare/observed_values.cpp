#include "coupling/compare/si_units.hpp"
#include "coupling/compare/source.hpp"
#include "coupling/compare/value_table.hpp"
#include "coupling/record/atomic_file.hpp"
#include "coupling/record/csv.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling {
namespace {

/// What stands over a column: words ("setup"), or a quantity with its unit ("max_force [N]").
struct ValueColumn {
  std::string name;
  SiScale si; ///< of a quantity
  bool is_text;
};

ValueColumn column_of(std::string const& header, std::string const& where) {
  auto const open = header.rfind(" [");
  if (open == std::string::npos || !header.ends_with(']'))
    return {header, {1.0, ""}, true};
  auto const name = header.substr(0, open);
  return {name,
          si_scale(header.substr(open + 2, header.size() - open - 3), where + ": column " + name),
          false};
}

/// "max_force" for "max_force_sd", which holds its standard uncertainty; else nothing.
std::string uncertain_quantity(std::string const& name) {
  return name.ends_with("_sd") ? name.substr(0, name.size() - 3) : "";
}

void add_words(ValueRow& row, std::string const& column, std::string const& text) {
  if (text.empty())
    return;
  if (column == "setup")
    row.setup = text;
  row.label += (row.label.empty() ? "" : " ") + text;
}

ValueRow row_from(std::vector<ValueColumn> const& columns, CsvLine const& line,
                  std::string const& file) {
  VALIDATE(line.fields.size() == columns.size(),
           fmt::format("{}:{}: has {} fields (the header names {}). Is a comma missing?", file,
                       line.number, line.fields.size(), columns.size()));
  ValueRow row;
  std::map<std::string, double> numbers;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    auto const& [name, si, is_text] = columns[k];
    if (is_text)
      add_words(row, name, line.fields[k]);
    else if (!line.fields[k].empty())
      numbers[name] = si.factor * csv_number(line.fields[k], file, line.number, name);
  }
  for (auto const& [name, si, is_text] : columns) {
    if (is_text || !numbers.contains(name) || !std::isfinite(numbers[name]))
      continue;
    if (auto const of = uncertain_quantity(name); !of.empty()) {
      VALIDATE(numbers[name] >= 0.0 && numbers.contains(of),
               fmt::format("{}:{}: {} = {} is no uncertainty of a value in that row. Is the sign "
                           "or the name wrong?",
                           file, line.number, name, numbers[name]));
      continue;
    }
    ObservedValue value{.name = name, .value = numbers[name], .unit = si.unit, .source = row.label};
    if (auto const sd = numbers.find(name + "_sd"); sd != numbers.end())
      value.sd = sd->second;
    row.values.push_back(std::move(value));
  }
  return row;
}

} // namespace

bool is_value_table(std::string const& text, std::string const& name) {
  auto const lines = split_csv(text, name);
  return !lines.empty() && std::ranges::none_of(lines.front().fields, [](std::string const& field) {
    return field.starts_with("time [") || field.starts_with("punch_gap [");
  });
}

std::vector<ValueRow> read_value_table(std::filesystem::path const& file) {
  auto const name = file.string();
  auto const lines = split_csv(read_file(file), name);
  VALIDATE(lines.size() > 1, name + ": holds no values (a header with 'name [unit]' and rows are "
                                    "needed). Is it the right file?");
  auto const where = fmt::format("{}:{}", name, lines.front().number);
  std::vector<ValueColumn> columns;
  for (auto const& header : lines.front().fields)
    columns.push_back(column_of(header, where));
  VALIDATE(
      std::ranges::any_of(columns, [](auto const& c) { return !c.is_text; }),
      where +
          ": has no column 'name [unit]' (a number without unit means nothing). Add the units?");
  std::vector<ValueRow> rows;
  for (std::size_t k = 1; k < lines.size(); ++k)
    rows.push_back(row_from(columns, lines[k], name));
  return rows;
}

std::vector<ObservedValue> read_observed_values(std::filesystem::path const& file,
                                                std::string const& setup) {
  std::vector<ObservedValue> values;
  for (auto& row : read_value_table(file)) {
    if (!setup.empty() && !row.setup.empty() && row.setup != setup)
      continue;
    for (auto& value : row.values) {
      value.source = file.stem().string() + (value.source.empty() ? "" : " " + value.source);
      values.push_back(std::move(value));
    }
  }
  return values;
}

std::vector<ComparedValue> beside_observed(Summary const& ours,
                                           std::vector<ObservedValue> const& theirs) {
  auto const values = values_of(ours);
  std::vector<ComparedValue> rows;
  for (auto const& observed : theirs)
    if (auto const found = values.find(observed.name); found != values.end())
      rows.push_back(
          {observed.name, observed.unit, found->second.value, observed.value, observed.source});
  return rows;
}

} // namespace coupling
