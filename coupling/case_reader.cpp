#include "coupling/case_reader.hpp"

#include "coupling/case_schema.hpp"
#include "coupling/case_value.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

namespace coupling {

EntryText const& CaseReader::entry(std::string const& path) const {
  auto const row = text_.find(path);
  EXPECT(row != text_.end());
  return row->second;
}

void CaseReader::refuse(std::string const& path, std::string_view problem) const {
  EntryText const& found = entry(path);
  refuse_entry(found.where, path, found.is_given ? found.text : found.text + " (default)", problem);
}

double CaseReader::number(std::string const& path) {
  Entry const& row = *find_entry(path);
  double const value = parse_number(row, entry(path).text);
  resolve(path, print_quantity(value, row.physical));
  return value;
}

std::uint64_t CaseReader::count(std::string const& path) {
  std::uint64_t const value = parse_count(*find_entry(path), entry(path).text);
  resolve(path, fmt::format("{}", value));
  return value;
}

bool CaseReader::truth(std::string const& path) {
  bool const value = parse_truth(entry(path).text);
  resolve(path, print_truth(value));
  return value;
}

std::string CaseReader::choice(std::string const& path) {
  resolve(path, entry(path).text);
  return parse_choice(*find_entry(path), entry(path).text);
}

std::string CaseReader::words(std::string const& path) {
  resolve(path, entry(path).text);
  return entry(path).text;
}

std::vector<SizeClass> CaseReader::size_classes(std::string const& path) {
  std::vector<SizeClass> sizes = parse_size_classes(*find_entry(path), entry(path).text);
  resolve(path, print_size_classes(sizes));
  return sizes;
}

std::vector<std::string> CaseReader::tools(std::string const& path) {
  std::vector<std::string> names = parse_tools(entry(path).text);
  resolve(path, print_list(names));
  return names;
}

std::filesystem::path CaseReader::file(std::string const& path) {
  std::string const& written = entry(path).text;
  if (written.empty()) {
    resolve(path, "");
    return {};
  }
  std::filesystem::path const absolute =
      std::filesystem::absolute(folder_ / written).lexically_normal();
  std::error_code unreadable;
  if (!std::filesystem::exists(absolute, unreadable))
    refuse(
        path,
        fmt::format("does not exist (looked for {}; paths start at the case file). Is it misspelt?",
                    absolute.string()));
  // The resolved case must be able to say where the file is.
  if (absolute.string().find_first_of("#\n\r\t") != std::string::npos)
    refuse(path, "lies in a folder whose name holds '#' or a line end (a .prm file could not hold "
                 "it). Rename it?");
  resolve(path, absolute.string());
  return absolute;
}

void CaseReader::refuse_unread(std::string const& section, std::string const& reason) const {
  for (auto const& [path, found] : text_) {
    if (!path.starts_with(section) || !found.is_given || resolved_.contains(path))
      continue;
    Entry const& row = *find_entry(path);
    bool const says_nothing =
        found.text.empty() ||
        (row.kind == EntryKind::quantity && parse_number(row, found.text) == 0.0) ||
        (row.kind == EntryKind::truth && !parse_truth(found.text));
    if (!says_nothing)
      refuse(path, fmt::format("is not used ({}). Remove it?", reason));
  }
}

} // namespace coupling
