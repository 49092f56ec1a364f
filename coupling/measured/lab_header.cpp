#include "coupling/measured/lab_header.hpp"

#include "coupling/measured/channel_kinds.hpp"
#include "coupling/measured/lab_words.hpp"
#include "coupling/nearest_name.hpp"
#include "coupling/quote.hpp"
#include "coupling/units.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <ranges>

namespace coupling::measured {
namespace {

/// A line taken for the header, split.
struct HeaderLine {
  std::size_t place = 0; ///< in LabText::lines
  std::size_t number = 0;
  char delimiter = ',';
  std::vector<std::string> fields = {};
  std::vector<std::string> meanings = {}; ///< channel, `time`, or empty, of each field
  std::ptrdiff_t n_known = 0;
};

std::string meaning_of(std::string const& field, LabLayout const& layout) {
  auto const name = parse_column_header(field).name;
  for (auto const& [channel, choice] : layout.columns)
    if (choice.name == name || choice.name == field)
      return channel == "position_time" ? "time" : channel;
  auto const found = recognised_column(name);
  auto const channel = found == "travel" ? "punch_gap" : found;
  // Where a person named the channel's column, no other one is it.
  return layout.columns.contains(channel) ? "" : channel;
}

HeaderLine best_header(LabText const& text, std::string const& name, LabLayout const& layout) {
  constexpr std::size_t longest_preamble = 200;
  HeaderLine best;
  for (std::size_t k = 0; k < std::min(text.lines.size(), longest_preamble); ++k)
    for (char const delimiter : {',', ';', '\t'}) {
      std::string_view line = text.lines[k].text;
      if (line.starts_with('#'))
        line.remove_prefix(1);
      HeaderLine header{.place = k,
                        .number = text.lines[k].number,
                        .delimiter = delimiter,
                        .fields = split_fields(line, delimiter)};
      for (auto const& field : header.fields)
        header.meanings.push_back(meaning_of(field, layout));
      header.n_known =
          std::ranges::count_if(header.meanings, [](auto const& m) { return !m.empty(); });
      if (header.n_known > best.n_known)
        best = std::move(header);
    }
  VALIDATE(best.n_known > 0,
           fmt::format("{}:{}: no line names the columns (looked for names such as 'time [s]', "
                       "'punch_gap [m]', 'upper_punch_force [N]' between commas, semicolons or "
                       "tabs). Name them in measured.json, in \"columns\"?",
                       name, text.lines.front().number));
  return best;
}

bool is_unit(std::string const& text) {
  try {
    parse_unit(unit_symbol(text));
    return true;
  } catch (dem::InvalidInput const&) {
    return false;
  }
}

/// The line below the header, if it holds nothing but units: `s;kN;mm` or `[s];[kN];[mm]`.
std::vector<std::string> units_line(LabText const& text, HeaderLine const& header) {
  if (header.place + 1 >= text.lines.size())
    return {};
  auto fields = split_fields(text.lines[header.place + 1].text, header.delimiter);
  if (fields.size() != header.fields.size())
    return {};
  for (auto& field : fields) {
    bool const is_bracketed = field.size() > 2 && ((field[0] == '[' && field.ends_with(']')) ||
                                                   (field[0] == '(' && field.ends_with(')')));
    if (is_bracketed)
      field = field.substr(1, field.size() - 2);
  }
  // A 1 could be a number as well.
  for (std::size_t k = 0; k < fields.size(); ++k)
    if (!header.meanings[k].empty() && (fields[k] == "1" || !is_unit(fields[k])))
      return {};
  return fields;
}

std::string checked_unit(std::string const& written, Physical physical, std::string const& where,
                         std::vector<std::string>& remarks) {
  VALIDATE(
      !written.empty(),
      fmt::format("{}: has no unit (a number without unit means nothing). Write 'name [unit]', "
                  "or give it in measured.json, in \"columns\"?",
                  where));
  auto symbol = unit_symbol(written);
  Unit unit;
  try {
    unit = parse_unit(symbol);
  } catch (dem::InvalidInput const& problem) {
    throw dem::InvalidInput(fmt::format("{}: {}", where, problem.what()));
  }
  auto const& kind = describe(physical);
  VALIDATE(unit.dimension == kind.dimension,
           fmt::format("{}: is in {} ({} is needed: {}). Are two names swapped?", where,
                       quote(written), kind.words, kind.examples));
  if (symbol != written)
    remarks.push_back(fmt::format("unit '{}' is read as {}", quote(written), symbol));
  return symbol;
}

/// A travel becomes a gap where its zero is known.
void set_travel(LabColumn& column, ColumnChoice const* choice, std::string const& where,
                std::vector<std::string>& remarks) {
  bool const has_zero = choice != nullptr && choice->at_zero.has_value();
  bool const is_travel = recognised_column(column.name) == "travel";
  VALIDATE(has_zero || choice != nullptr || !is_travel,
           fmt::format("{}: is a travel (its zero is not said, so it is no gap yet). Give in "
                       "measured.json \"columns\": {{\"punch_gap\": {{\"name\": \"{}\", "
                       "\"at_zero\": ...}}}}, the gap where it reads zero?",
                       where, quote(column.name)));
  if (!has_zero)
    return;
  column.is_travel = true;
  column.at_zero = *choice->at_zero;
  remarks.push_back(fmt::format("punch_gap = {} m - '{}'", column.at_zero, quote(column.name)));
}

Physical physical_of(std::string const& channel) {
  auto const* const kind = find_kind(channel_kinds(), channel);
  return kind == nullptr ? Physical::time : kind->physical;
}

void add_column(LabHeader& read, HeaderLine const& line, std::size_t field,
                std::string const& unit_below, LabLayout const& layout, std::string const& file) {
  auto const& channel = line.meanings[field];
  auto const written = parse_column_header(line.fields[field]);
  auto const where =
      fmt::format("{}:{}: column '{}'", file, line.number, quote(line.fields[field]));
  if (auto const other = read.columns.find(channel); other != read.columns.end())
    throw dem::InvalidInput(
        fmt::format("{}: is {}, and so is '{}' (one of them would be lost). Say which in "
                    "measured.json, in \"columns\"?",
                    where, channel, quote(other->second.name)));
  auto const chosen = layout.columns.find(channel);
  ColumnChoice const* const choice = chosen == layout.columns.end() ? nullptr : &chosen->second;
  auto const& unit = choice != nullptr && !choice->unit.empty() ? choice->unit
                     : written.unit.empty()                     ? unit_below
                                                                : written.unit;
  LabColumn column{.field = field,
                   .name = written.name,
                   .unit = checked_unit(unit, physical_of(channel), where, read.remarks),
                   .physical = physical_of(channel)};
  if (channel == "punch_gap")
    set_travel(column, choice, where, read.remarks);
  read.columns.emplace(channel, std::move(column));
}

void check_needed(LabHeader const& read, HeaderLine const& line, LabLayout const& layout,
                  std::vector<std::string> const& needed, std::string const& file) {
  for (auto const& channel : needed) {
    if (read.columns.contains(channel))
      continue;
    std::string nearest;
    for (std::size_t k = 0; k < line.fields.size() && nearest.empty(); ++k)
      if (line.meanings[k].empty())
        nearest =
            nearest_name(folded(parse_column_header(line.fields[k]).name), recognised_names());
    auto const chosen = layout.columns.find(channel);
    auto const asked =
        chosen == layout.columns.end()
            ? std::string(nearest.empty() ? "" : fmt::format(" ('{}' is known)", nearest))
            : fmt::format(" (measured.json names '{}')", quote(chosen->second.name));
    throw dem::InvalidInput(fmt::format(
        "{}:{}: no column is {} (the header names: {}). Is a name misspelt{}, or to be "
        "given in measured.json, in \"columns\"?",
        file, line.number, channel, quote(fmt::format("{}", fmt::join(line.fields, ", "))), asked));
  }
}

} // namespace

LabHeader find_lab_header(LabText const& text, std::string const& name, LabLayout const& layout,
                          std::vector<std::string> const& needed) {
  HeaderLine const line = best_header(text, name, layout);
  LabHeader read{.delimiter = line.delimiter,
                 .n_fields = line.fields.size(),
                 .first_row = line.place + 1,
                 .columns = {},
                 .remarks = {}};
  auto const below = units_line(text, line);
  if (!below.empty())
    ++read.first_row;
  if (line.place > 0)
    read.remarks.push_back(
        fmt::format("lines before line {}, which names the columns, are no data", line.number));
  for (std::size_t k = 0; k < line.fields.size(); ++k) {
    if (!line.meanings[k].empty())
      add_column(read, line, k, below.empty() ? "" : below[k], layout, name);
    else if (!line.fields[k].empty())
      read.remarks.push_back(fmt::format("column '{}' is not used", quote(line.fields[k])));
  }
  check_needed(read, line, layout, needed, name);
  return read;
}

} // namespace coupling::measured
