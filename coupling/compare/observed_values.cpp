#include "coupling/compare/si_units.hpp"
#include "coupling/compare/source.hpp"
#include "coupling/compare/value_table.hpp"
#include "coupling/record/atomic_file.hpp"
#include "coupling/record/csv.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace coupling {
namespace {

std::optional<std::size_t> place_of(CsvLine const& header, std::string_view name) {
  auto const found = std::ranges::find(header.fields, name);
  if (found == header.fields.end())
    return std::nullopt;
  return static_cast<std::size_t>(found - header.fields.begin());
}

ValueRow row_from(CsvLine const& header, CsvLine const& line, std::string const& file) {
  VALIDATE(line.fields.size() == header.fields.size(),
           fmt::format("{}:{}: has {} fields (the header names {}). Is a comma missing?", file,
                       line.number, line.fields.size(), header.fields.size()));
  auto const text = [&](std::string_view name) {
    auto const k = place_of(header, name);
    return k ? line.fields[*k] : std::string();
  };
  auto const unit = text("unit").empty() ? "1" : text("unit");
  auto const where = fmt::format("{}:{}: {}", file, line.number, text("quantity"));
  auto const si = si_scale(unit, where);
  ObservedValue value{.name = text("quantity"),
                      .value = si.factor * csv_number(text("value"), file, line.number, "value"),
                      .unit = si.unit,
                      .source = text("source")};
  VALIDATE(std::isfinite(value.value), where + " has no finite value. Leave the row out?");
  if (!text("sd").empty())
    value.sd = si.factor * csv_number(text("sd"), file, line.number, "sd");
  VALIDATE(!(value.sd < 0.0), where + " has a negative uncertainty. Is the sign wrong?");
  return {text("setup"), std::move(value)};
}

} // namespace

bool is_value_table(std::string const& text) {
  auto const first = text.substr(0, text.find('\n'));
  return first.find("quantity") != std::string::npos && first.find("value") != std::string::npos;
}

std::vector<ValueRow> read_value_table(std::filesystem::path const& file) {
  auto const name = file.string();
  auto const lines = split_csv(read_file(file), name);
  VALIDATE(
      !lines.empty(),
      name +
          ": is empty (a header with quantity, value and unit is needed). Is it the right file?");
  auto const& header = lines.front();
  for (auto const* needed : {"quantity", "value", "unit"})
    VALIDATE(place_of(header, needed),
             fmt::format("{}:{}: has no column '{}' (a number needs its name and unit). "
                         "Add it to the header?",
                         name, header.number, needed));
  std::vector<ValueRow> rows;
  for (std::size_t k = 1; k < lines.size(); ++k)
    rows.push_back(row_from(header, lines[k], name));
  return rows;
}

std::vector<ObservedValue> read_observed_values(std::filesystem::path const& file,
                                                std::string const& setup) {
  std::vector<ObservedValue> values;
  for (auto& row : read_value_table(file))
    if (setup.empty() || row.setup.empty() || row.setup == setup)
      values.push_back(std::move(row.value));
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
