#include "coupling/measured/lab_file.hpp"

#include "coupling/measured/decimal_mark.hpp"
#include "coupling/measured/lab_header.hpp"
#include "coupling/measured/lab_numbers.hpp"
#include "coupling/measured/limits.hpp"
#include "coupling/quote.hpp"
#include "coupling/record/atomic_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace coupling::measured {
namespace {

constexpr double gap_value = std::numeric_limits<double>::quiet_NaN();

std::vector<LabRow> rows_of(LabText const& text, LabHeader const& header) {
  std::vector<LabRow> rows;
  for (std::size_t k = header.first_row; k < text.lines.size(); ++k) {
    auto const& line = text.lines[k];
    if (line.text.starts_with('#'))
      continue;
    LabRow row{line.number, split_fields(line.text, header.delimiter)};
    // Some programs end each row with a delimiter, but not the header.
    while (row.fields.size() > header.n_fields && row.fields.back().empty())
      row.fields.pop_back();
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The value of a cell in SI; NaN for a gap.
/// @throws dem::InvalidInput  the reason why the row is corrupt
double cell_value(std::string const& cell, std::string const& channel, LabColumn const& column,
                  char mark) {
  if (is_gap(cell))
    return gap_value;
  auto const number = plain_number(cell, mark);
  VALIDATE(number.has_value(), fmt::format("{} = '{}' is no number", channel, quote(cell)));
  double value = gap_value;
  try {
    value = parse_quantity(*number + " " + column.unit, column.physical);
  } catch (dem::InvalidInput const&) {
    throw dem::InvalidInput(
        fmt::format("{} = '{}' is no number that a computer can hold", channel, quote(cell)));
  }
  return column.is_travel ? column.at_zero - value : value;
}

/// All values of a row by channel, `time` among them.
std::map<std::string, double> row_values(LabRow const& row, LabHeader const& header, char mark) {
  VALIDATE(row.fields.size() == header.n_fields,
           fmt::format("it has {} fields and the header {}", row.fields.size(), header.n_fields));
  std::map<std::string, double> values;
  for (auto const& [channel, column] : header.columns)
    values[channel] = cell_value(row.fields[column.field], channel, column, mark);
  VALIDATE(!values.contains("time") || std::isfinite(values["time"]), "it has no time");
  return values;
}

void add_row(LabTable& table, LabRow const& row, LabHeader const& header, char mark,
             std::string const& file) {
  try {
    for (auto const& [channel, value] : row_values(row, header, mark))
      (channel == "time" ? table.time : table.series[channel]).push_back(value);
    table.rows.push_back(row.number);
  } catch (dem::InvalidInput const& reason) {
    ++table.n_corrupt;
    table.decisions.push_back({file, row.number, fmt::format("left out: {}", reason.what())});
  }
}

void check_rows(LabTable const& table, std::string const& path, std::size_t n_rows) {
  VALIDATE(n_rows > 0, fmt::format("{}: has no rows below its header (nothing was measured). Was "
                                   "its writing interrupted?",
                                   path));
  bool const are_few =
      table.n_corrupt <= 1 ||
      static_cast<double>(table.n_corrupt) <= limits::corrupt_share * static_cast<double>(n_rows);
  VALIDATE(
      are_few && !table.rows.empty(),
      fmt::format("{}: {} of {} rows are corrupt (at most {:.0f} % may be; the first: row {}, {}). "
                  "Is it the right file, or its header or decimal mark another?",
                  path, table.n_corrupt, n_rows, 100 * limits::corrupt_share,
                  table.decisions.front().row, table.decisions.front().what));
}

/// Remarks on the whole file go before the rows.
void add_remarks(LabTable& table, LabText const& text, LabHeader const& header, char mark,
                 std::string const& file) {
  std::vector<std::string> remarks = text.remarks;
  if (header.delimiter != ',')
    remarks.push_back(
        fmt::format("fields are parted by {}", header.delimiter == ';' ? "semicolons" : "tabs"));
  if (mark == ',')
    remarks.emplace_back("decimals are written with a comma");
  remarks.insert(remarks.end(), header.remarks.begin(), header.remarks.end());
  std::vector<Decision> decisions;
  decisions.reserve(remarks.size());
  for (auto const& remark : remarks)
    decisions.push_back({file, 0, remark});
  table.decisions.insert(table.decisions.begin(), decisions.begin(), decisions.end());
}

} // namespace

LabTable parse_lab_table(std::string_view bytes, std::string const& path, std::string const& file,
                         LabLayout const& layout, std::vector<std::string> const& needed) {
  LabText const text = parse_lab_text(bytes, path);
  LabHeader const header = find_lab_header(text, path, layout, needed);
  auto const rows = rows_of(text, header);
  char const mark = layout.decimal_mark.empty() ? decimal_mark_of(rows, header, path)
                                                : layout.decimal_mark.front();
  LabTable table;
  for (auto const& [channel, column] : header.columns) {
    // A channel that no row holds is there all the same.
    if (channel != "time")
      table.series[channel] = {};
    table.unit_factors[channel] = parse_quantity("1 " + column.unit, column.physical);
  }
  for (auto const& row : rows)
    add_row(table, row, header, mark, file);
  check_rows(table, path, rows.size());
  add_remarks(table, text, header, mark, file);
  return table;
}

LabTable read_lab_file(std::filesystem::path const& file, LabLayout const& layout) {
  static std::vector<std::string> const needed = {"time", "punch_gap", "upper_punch_force"};
  return parse_lab_table(read_file(file), file.string(), file.filename().string(), layout, needed);
}

} // namespace coupling::measured
