#include "coupling/case_setups.hpp"

#include "coupling/case_schema.hpp"
#include "coupling/case_text.hpp"
#include "coupling/nearest_name.hpp"
#include "coupling/quote.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace coupling {

namespace {

struct SetupRow {
  int line;
  std::vector<std::string> cells; // as many as columns
};

struct SetupTable {
  std::string name;                              // of the file
  std::vector<std::vector<std::string>> columns; // entries that a column sets; none for a remark
  std::vector<SetupRow> rows;
};

std::string trim(std::string const& text) {
  auto const first = text.find_first_not_of(" \t\r");
  return first == std::string::npos
             ? ""
             : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The cells of one line; a cell in double quotes may hold commas.
std::vector<std::string> split_cells(std::string const& line, std::string const& where) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (char const c : line) {
    if (c == '"')
      is_quoted = !is_quoted;
    else if (c == ',' && !is_quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  VALIDATE(!is_quoted, where + ": has a quote that is never closed. Add the other one?");
  for (std::string& cell : cells)
    cell = trim(cell);
  return cells;
}

std::vector<std::string> read_header(std::string const& header, std::string const& where) {
  std::vector<std::string> paths;
  if (header.starts_with('('))
    return paths;
  std::istringstream parts(header);
  for (std::string path; std::getline(parts, path, '+');) {
    path = trim(path);
    VALIDATE(find_entry(path) != nullptr, fmt::format("{}: column '{}' is no entry of a case.{}",
                                                      where, quote(path), suggest_entry(path)));
    paths.push_back(path);
  }
  VALIDATE(!paths.empty(), where + ": has a column without a header. Remove it?");
  return paths;
}

void take_row(SetupTable& table, std::vector<std::string> cells, int line) {
  std::string const where = fmt::format("{}:{}", table.name, line);
  VALIDATE(cells.size() == table.columns.size() + 1,
           fmt::format("{}: has {} cells (the header has {}). Is a comma missing, or a cell with "
                       "commas without quotes?",
                       where, cells.size(), table.columns.size() + 1));
  VALIDATE(!cells[0].empty(), where + ": names no setup. Fill the first cell?");
  for (SetupRow const& row : table.rows)
    VALIDATE(row.cells[0] != cells[0],
             fmt::format("{}: setup {} is listed twice (first on line {}). Rename one?", where,
                         cells[0], row.line));
  for (std::size_t column = 0; column < table.columns.size(); ++column)
    for (std::string const& path : table.columns[column])
      if (!cells[column + 1].empty())
        check_assignment(where, path, cells[column + 1]);
  table.rows.push_back({line, std::move(cells)});
}

SetupTable read_table(std::filesystem::path const& file) {
  SetupTable table{.name = file.string(), .columns = {}, .rows = {}};
  std::ifstream in(file, std::ios::binary);
  VALIDATE(
      in.is_open(),
      fmt::format(
          "{}: does not exist (named setups stand there, beside the case). Run the case without "
          "--setup?",
          table.name));
  std::string text{std::istreambuf_iterator<char>(in), {}};
  VALIDATE(!in.bad(), fmt::format("{}: cannot be read. Is it a file?", table.name));
  check_is_text(text, table.name);
  std::istringstream lines(text);
  bool has_header = false;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (trim(line).empty() || line.starts_with('#'))
      continue;
    std::string const where = fmt::format("{}:{}", table.name, number);
    std::vector<std::string> cells = split_cells(line, where);
    if (has_header) {
      take_row(table, std::move(cells), number);
      continue;
    }
    VALIDATE(cells[0] == "setup",
             where + ": does not begin with the column 'setup'. Is this a table of setups?");
    for (std::size_t i = 1; i < cells.size(); ++i)
      table.columns.push_back(read_header(cells[i], where));
    has_header = true;
  }
  VALIDATE(!table.rows.empty(),
           fmt::format("{}: lists no setup. Is it the right file?", table.name));
  return table;
}

NamedSetup setup_of(SetupTable const& table, SetupRow const& row) {
  NamedSetup setup{row.cells[0], fmt::format("{}:{}", table.name, row.line), {}};
  for (std::size_t column = 0; column < table.columns.size(); ++column)
    for (std::string const& path : table.columns[column])
      if (!row.cells[column + 1].empty())
        setup.values.push_back({path, row.cells[column + 1], setup.where});
  return setup;
}

std::vector<std::string> names_of(std::vector<NamedSetup> const& setups) {
  std::vector<std::string> names;
  for (NamedSetup const& setup : setups)
    names.push_back(setup.name);
  return names;
}

std::filesystem::path table_beside(std::filesystem::path const& case_file) {
  return case_file.parent_path() / "settings.csv";
}

/// The `most` names nearest to a text, for a message.
std::vector<std::string> nearest(std::vector<std::string> names, std::string_view text,
                                 std::size_t most) {
  std::ranges::stable_sort(names, {},
                           [&](std::string const& name) { return edit_distance(text, name); });
  names.resize(std::min(most, names.size()));
  return names;
}

} // namespace

std::vector<NamedSetup> read_setups(std::filesystem::path const& table_file) {
  SetupTable const table = read_table(table_file);
  std::vector<NamedSetup> setups;
  for (SetupRow const& row : table.rows)
    setups.push_back(setup_of(table, row));
  return setups;
}

NamedSetup const& find_setup(std::vector<NamedSetup> const& setups, std::string_view name,
                             std::filesystem::path const& table) {
  auto const found = std::ranges::find(setups, name, &NamedSetup::name);
  if (found != setups.end())
    return *found;
  throw dem::InvalidInput(
      fmt::format("{}: has no setup '{}' (it lists {}). Did you mean one of {}?", table.string(),
                  quote(name), setups.size(), fmt::join(nearest(names_of(setups), name, 3), ", ")));
}

std::vector<std::string> setup_names(std::filesystem::path const& case_file) {
  return names_of(read_setups(table_beside(case_file)));
}

std::vector<std::string> setup_overrides(std::filesystem::path const& case_file,
                                         std::string_view setup_name) {
  auto const table = table_beside(case_file);
  auto const setups = read_setups(table);
  std::vector<std::string> overrides;
  for (PlacedValue const& value : find_setup(setups, setup_name, table).values)
    overrides.push_back(fmt::format("{}={}", value.path, value.text));
  return overrides;
}

} // namespace coupling
