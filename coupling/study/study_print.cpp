#include "coupling/study/study_print.hpp"

#include <fmt/format.h>

#include <iterator>

namespace coupling::study {
namespace {

/// Lines inside one level of subsections.
class Sections {
public:
  void set(std::string_view section, std::string_view name, std::string_view value) {
    if (value.empty())
      return;
    if (section != open_)
      enter(section);
    fmt::format_to(std::back_inserter(text_), "{}set {} = {}\n", open_.empty() ? "" : "  ", name,
                   value);
  }

  std::string finish() {
    enter("");
    return std::move(text_);
  }

private:
  void enter(std::string_view section) {
    if (!open_.empty())
      text_ += "end\n";
    open_ = section;
    if (!open_.empty())
      text_ += fmt::format("\nsubsection {}\n", open_);
  }

  std::string open_;
  std::string text_;
};

std::string joined(std::vector<std::filesystem::path> const& files) {
  std::string text;
  for (auto const& file : files)
    text += (text.empty() ? "" : ", ") + file.string();
  return text;
}

/// Entries of numbered sections: `Factor #` for each number.
void print_numbered(Sections& sections, StudyText const& text, std::string const& kind) {
  for (int const number : text.numbers(kind))
    for (Entry const& entry : study_schema())
      if (entry.section() == kind + " #") {
        auto const section = fmt::format("{} {}", kind, number);
        auto const path = fmt::format("{}/{}", section, entry.name());
        if (text.has(path))
          sections.set(section, entry.name(), text.text(path));
      }
}

} // namespace

std::string print_study(StudyText const& text, StudyFile const& study) {
  Sections sections;
  sections.set("", "Title", study.title);
  sections.set("", "Case", study.case_file.string());
  sections.set("", "Model", study.model);
  for (auto const& value : study.common)
    sections.set(common_section, value.path, value.text);
  auto const print = [&](std::string_view of) {
    for (Entry const& entry : study_schema()) {
      if (entry.section() != of)
        continue;
      auto value = text.has(entry.path) ? text.text(entry.path) : "";
      if (entry.path == "Design/Kind")
        value = study.design.kind_name;
      else if (entry.path == "Design/Table")
        value = study.design.table.string();
      else if (entry.path == "Design/Results")
        value = study.design.results.string();
      else if (entry.path == "Reference/Tables")
        value = joined(study.references.tables);
      sections.set(of, entry.name(), value);
    }
  };
  print("Design");
  print_numbered(sections, text, "Factor");
  print_numbered(sections, text, "Response");
  for (auto const* section : {"Calibration", "Extrapolation", "Cost", "Reference"})
    print(section);
  return sections.finish();
}

std::string describe_study_entries() {
  std::string text =
      "# Every entry of a study file with its default. Sections with # are numbered from 1.\n"
      "# 'subsection Case entries' holds entries of the case for every run: set Powder/Total mass "
      "= 4 g\n";
  std::string section;
  for (Entry const& entry : study_schema()) {
    if (entry.section() != section) {
      text += fmt::format("{}\nsubsection {}\n", section.empty() ? "" : "end\n", entry.section());
      section = entry.section();
    }
    std::string const indent = section.empty() ? "" : "  ";
    text += fmt::format("{}# {}{}\n", indent, entry.description,
                        entry.kind == EntryKind::file ? ""
                                                      : " Allowed: " + describe_range(entry) + ".");
    text += fmt::format("{}set {} ={}{}\n", indent, entry.name(), entry.standard.empty() ? "" : " ",
                        entry.standard);
  }
  return text + "end\n";
}

} // namespace coupling::study
