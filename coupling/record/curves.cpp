#include "coupling/record/curves.hpp"

#include "coupling/record/atomic_file.hpp"
#include "coupling/record/csv.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace coupling {
namespace {

constexpr char const* stage_column = "stage";

std::string header_of(PressRecord::Column const& column) {
  return csv_field(fmt::format("{} [{}]", column.name, column.unit));
}

/// Splits "time [s]" into name and unit.
PressRecord::Column column_of(std::string const& header, std::string const& file,
                              std::size_t line) {
  auto const open = header.rfind(" [");
  bool const has_unit =
      open != std::string::npos && open > 0 && header.size() > open + 3 && header.ends_with(']');
  VALIDATE(has_unit,
           fmt::format("{}:{}: column '{}' has no unit (a number without unit means nothing). "
                       "Write it as 'name [unit]'?",
                       file, line, header));
  return {header.substr(0, open), header.substr(open + 2, header.size() - open - 3)};
}

struct Header {
  std::vector<PressRecord::Column> columns;
  std::optional<std::size_t> stage; ///< place of the column `stage`
  std::size_t n_fields;
};

Header parse_header(CsvLine const& line, std::string const& file) {
  Header header{{}, {}, line.fields.size()};
  for (std::size_t k = 0; k < line.fields.size(); ++k) {
    if (line.fields[k] == stage_column && !header.stage) {
      header.stage = k;
      continue;
    }
    PressRecord::Column column = column_of(line.fields[k], file, line.number);
    bool const is_new =
        std::ranges::none_of(header.columns, [&](auto const& c) { return c.name == column.name; });
    VALIDATE(is_new, fmt::format("{}:{}: column '{}' occurs twice. Which one is meant?", file,
                                 line.number, column.name));
    header.columns.push_back(std::move(column));
  }
  return header;
}

void add_row(PressRecord& record, Header const& header, CsvLine const& line,
             std::string const& file) {
  VALIDATE(line.fields.size() == header.n_fields,
           fmt::format("{}:{}: has {} fields (the header names {}). Is the row cut off?", file,
                       line.number, line.fields.size(), header.n_fields));
  std::vector<double> values;
  values.reserve(header.columns.size());
  std::string stage;
  for (std::size_t k = 0; k < line.fields.size(); ++k) {
    if (k == header.stage)
      stage = line.fields[k];
    else
      values.push_back(
          csv_number(line.fields[k], file, line.number, header.columns[values.size()].name));
  }
  record.add_row(std::move(stage), std::move(values));
}

} // namespace

void write_curves(std::filesystem::path const& file, PressRecord const& record) {
  std::string text;
  auto const& columns = record.columns();
  for (std::size_t k = 0; k < columns.size(); ++k) {
    text += header_of(columns[k]);
    if (k == 0)
      text += fmt::format(",{}", stage_column);
    text += k + 1 < columns.size() ? ',' : '\n';
  }
  for (std::size_t i = 0; i < record.size(); ++i) {
    auto const& row = record.rows()[i];
    for (std::size_t k = 0; k < row.size(); ++k) {
      text += shortest(row[k]);
      if (k == 0)
        text += fmt::format(",{}", csv_field(record.stages()[i]));
      text += k + 1 < row.size() ? ',' : '\n';
    }
  }
  write_file(file, text);
}

PressRecord parse_curves(std::string const& text, std::string const& name) {
  auto const lines = split_csv(text, name);
  VALIDATE(
      !lines.empty(),
      fmt::format("{}: is empty (a header 'name [unit],...' and rows are needed). Is it the right "
                  "file?",
                  name));
  Header const header = parse_header(lines.front(), name);
  VALIDATE(!header.columns.empty() && lines.size() > 1,
           fmt::format("{}: has no data behind its header. Was its writing interrupted?", name));
  PressRecord record(header.columns);
  for (std::size_t i = 1; i < lines.size(); ++i)
    add_row(record, header, lines[i], name);
  return record;
}

PressRecord read_curves(std::filesystem::path const& file) {
  return parse_curves(read_file(file), file.string());
}

PressRecord until(PressRecord const& record, double time) {
  auto const times = record.column("time");
  PressRecord head(record.columns());
  for (std::size_t i = 0; i < record.size() && times[i] <= time; ++i)
    head.add_row(record.stages()[i], record.rows()[i]);
  return head;
}

} // namespace coupling
