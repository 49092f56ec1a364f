#include "coupling/compare/kept_observed.hpp"

#include "coupling/compare/source.hpp"
#include "coupling/record/atomic_file.hpp"
#include "coupling/record/csv.hpp"

#include <algorithm>

namespace coupling {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> tables_in(fs::path const& folder) {
  std::vector<fs::path> tables;
  if (fs::is_directory(folder))
    for (auto const& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".csv")
        tables.push_back(entry.path());
  std::ranges::sort(tables);
  return tables;
}

std::string line_of(std::vector<std::string> const& fields) {
  std::string line;
  for (std::string const& field : fields)
    line += (line.empty() ? "" : ",") + csv_field(field);
  return line + '\n';
}

} // namespace

std::vector<ObservedTable> observed_rows(fs::path const& case_file, std::string const& setup) {
  std::vector<ObservedTable> found;
  if (setup.empty())
    return found;
  for (auto const& table : tables_in(fs::absolute(case_file).parent_path() / "observed")) {
    auto const lines = split_csv(read_file(table), table.string());
    if (lines.empty())
      continue;
    auto const& header = lines.front().fields;
    auto const column =
        static_cast<std::size_t>(std::ranges::find(header, "setup") - header.begin());
    std::string rows;
    for (auto const& line : lines)
      if (column < line.fields.size() && line.fields[column] == setup)
        rows += line_of(line.fields);
    if (!rows.empty())
      found.push_back({table.filename(), line_of(header) + rows});
  }
  return found;
}

void keep_observed(std::vector<ObservedTable> const& tables, fs::path const& run_folder) {
  if (tables.empty())
    return;
  fs::create_directories(run_folder / "observed");
  for (auto const& [name, text] : tables)
    write_file(run_folder / "observed" / name, text);
}

std::vector<ObservedValue> kept_observed(fs::path const& run_folder) {
  std::vector<ObservedValue> values;
  for (auto const& table : tables_in(run_folder / "observed"))
    for (auto& value : read_observed_values(table))
      values.push_back(std::move(value));
  return values;
}

} // namespace coupling
