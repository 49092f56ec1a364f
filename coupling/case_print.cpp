#include "coupling/case_print.hpp"

#include "coupling/case_schema.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <iterator>
#include <vector>

namespace coupling {

namespace {

std::vector<std::string> split_path(std::string_view path) {
  std::vector<std::string> parts;
  while (!path.empty()) {
    auto const slash = path.find('/');
    parts.emplace_back(path.substr(0, slash));
    path.remove_prefix(slash == std::string_view::npos ? path.size() : slash + 1);
  }
  return parts;
}

/// Writes lines inside nested subsections, opening and closing what lies between one entry and the
/// next.
class PrmWriter {
public:
  /// Goes to a section and writes a line there, indented.
  void line(std::string_view section, std::string_view text) {
    go_to(split_path(section));
    indent();
    fmt::format_to(std::back_inserter(text_), "{}\n", text);
  }

  std::string finish() {
    go_to({});
    return std::move(text_);
  }

private:
  void indent() { text_.append(2 * open_.size(), ' '); }

  void go_to(std::vector<std::string> const& wanted) {
    std::size_t shared = 0;
    while (shared < open_.size() && shared < wanted.size() && open_[shared] == wanted[shared])
      ++shared;
    while (open_.size() > shared) {
      open_.pop_back();
      indent();
      text_ += "end\n";
    }
    while (open_.size() < wanted.size()) {
      if (open_.empty())
        text_ += '\n';
      indent();
      text_ += fmt::format("subsection {}\n", wanted[open_.size()]);
      open_.push_back(wanted[open_.size()]);
    }
  }

  std::vector<std::string> open_;
  std::string text_;
};

std::string set_line(Entry const& entry, std::string_view text) {
  // An empty value leaves no space at the end of the line.
  return text.empty() ? fmt::format("set {} =", entry.name())
                      : fmt::format("set {} = {}", entry.name(), text);
}

/// `m` of a length; empty where the entry has no unit.
std::string unit_of(Entry const& entry) {
  bool const is_number = entry.kind == EntryKind::quantity || entry.kind == EntryKind::size_classes;
  return is_number ? std::string(describe(entry.physical).si) : "";
}

} // namespace

std::string print_prm(std::map<std::string, std::string> const& values) {
  PrmWriter writer;
  for (Entry const& entry : case_schema()) {
    auto const value = values.find(entry.path);
    if (value != values.end())
      writer.line(entry.section(), set_line(entry, value->second));
  }
  return writer.finish();
}

std::string print_annotated_prm(std::map<std::string, std::string> const& used) {
  PrmWriter writer;
  writer.line("", "# Every entry of a case, with its default: the seed's press cycle.");
  writer.line(
      "", "# Entries that this case does not use are commented out. A bare number is in SI units.");
  for (Entry const& entry : case_schema()) {
    std::string const unit = unit_of(entry);
    writer.line(entry.section(), fmt::format("# {}{} Allowed: {}.", entry.description,
                                             unit.empty() ? "" : fmt::format(" Unit: {}.", unit),
                                             describe_range(entry)));
    writer.line(entry.section(),
                (used.contains(entry.path) ? "" : "# ") + set_line(entry, entry.standard));
  }
  return writer.finish();
}

std::string print_annotated_json(std::map<std::string, std::string> const& used) {
  nlohmann::ordered_json root = nlohmann::ordered_json::object();
  for (Entry const& entry : case_schema()) {
    nlohmann::ordered_json* at = &root;
    for (std::string const& part : split_path(entry.path))
      at = &(*at)[part];
    if (used.contains(entry.path))
      (*at)["value"] = entry.standard;
    (*at)["default"] = entry.standard;
    (*at)["unit"] = unit_of(entry);
    (*at)["range"] = describe_range(entry);
    (*at)["description"] = entry.description;
  }
  return root.dump(2) + "\n";
}

} // namespace coupling
