#include "coupling/case_schema.hpp"

#include "coupling/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace coupling {

std::string_view section_of(std::string_view path) {
  auto const slash = path.rfind('/');
  return slash == std::string_view::npos ? std::string_view{} : path.substr(0, slash);
}

std::string_view name_of(std::string_view path) {
  return path.substr(path.rfind('/') + 1);
}

std::string Entry::section() const {
  return std::string(section_of(path));
}

std::string Entry::name() const {
  return std::string(name_of(path));
}

Entry const* find_entry(std::string_view path) {
  static auto const rows = [] {
    std::map<std::string, Entry const*, std::less<>> by_path;
    for (Entry const& entry : case_schema())
      by_path.emplace(entry.path, &entry);
    return by_path;
  }();
  auto const row = rows.find(path);
  return row == rows.end() ? nullptr : row->second;
}

namespace {

std::set<std::string, std::less<>> const& all_sections() {
  static auto const sections = [] {
    std::set<std::string, std::less<>> all;
    for (Entry const& entry : case_schema())
      for (auto at = section_of(entry.path); !at.empty(); at = section_of(at))
        all.emplace(at);
    return all;
  }();
  return sections;
}

/// The entry of another section that bears this very name, as long as there is only one.
std::string only_namesake(std::string_view name) {
  std::string found;
  for (Entry const& entry : case_schema()) {
    if (name_of(entry.path) != name)
      continue;
    if (!found.empty())
      return "";
    found = entry.path;
  }
  return found;
}

std::vector<std::string> known_paths() {
  std::vector<std::string> paths;
  for (Entry const& entry : case_schema())
    paths.push_back(entry.path);
  return paths;
}

} // namespace

bool is_section(std::string_view path) {
  return all_sections().contains(path);
}

std::string suggest_section(std::string_view unknown_path) {
  std::vector<std::string> const names(all_sections().begin(), all_sections().end());
  return did_you_mean(unknown_path, names, "See all sections with: presscheck defaults?");
}

std::string suggest_entry(std::string_view unknown_path) {
  std::string_view const section = section_of(unknown_path);
  std::vector<std::string> siblings;
  for (Entry const& entry : case_schema())
    if (section_of(entry.path) == section)
      siblings.push_back(entry.name());
  std::string const sibling = nearest_name(name_of(unknown_path), siblings);
  if (!sibling.empty())
    return fmt::format(" Did you mean '{}{}{}'?", section, section.empty() ? "" : "/", sibling);
  std::string const namesake = only_namesake(name_of(unknown_path));
  if (!namesake.empty())
    return fmt::format(" Did you mean '{}'?", namesake);
  return did_you_mean(unknown_path, known_paths(), "See all entries with: presscheck defaults?");
}

std::string describe_range(Entry const& entry) {
  if (entry.kind == EntryKind::choice)
    return entry.choices;
  if (entry.kind == EntryKind::truth)
    return "true | false";
  if (entry.kind == EntryKind::tools)
    return "die, upper_punch, lower_punch";
  if (entry.kind == EntryKind::text || entry.kind == EntryKind::file)
    return "any";
  Range const& range = entry.range;
  auto const print = [&](double value) { return print_quantity(value, entry.physical); };
  bool const has_low = std::isfinite(range.low), has_high = std::isfinite(range.high);
  std::vector<std::string> bounds;
  if (has_low)
    bounds.push_back(fmt::format("{} {}", range.is_low_allowed ? ">=" : ">", print(range.low)));
  if (has_high)
    bounds.push_back(fmt::format("{} {}", range.is_high_allowed ? "<=" : "<", print(range.high)));
  return bounds.empty() ? "any" : fmt::format("{}", fmt::join(bounds, ", "));
}

} // namespace coupling
