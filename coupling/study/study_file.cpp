#include "coupling/study/study_file.hpp"

#include "coupling/quote.hpp"
#include "coupling/record/atomic_file.hpp"
#include "coupling/study/study_aims.hpp"
#include "coupling/study/study_print.hpp"
#include "coupling/study/study_quantities.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace coupling::study {
namespace {

namespace fs = std::filesystem;

DesignKind kind_of(std::string const& name) {
  if (name == "full_factorial")
    return DesignKind::full_factorial;
  if (name == "central_composite")
    return DesignKind::central_composite;
  return name == "latin_hypercube" ? DesignKind::latin_hypercube : DesignKind::table;
}

/// Entries of the design that another kind reads.
void refuse_unused(StudyText const& text, StudyDesign const& design) {
  static std::map<std::string, DesignKind> const readers{
      {"Design/Table", DesignKind::table},
      {"Design/Rows", DesignKind::table},
      {"Design/Runs", DesignKind::latin_hypercube},
      {"Design/Seed", DesignKind::latin_hypercube},
      {"Design/Centre runs", DesignKind::central_composite},
      {"Design/Axial points", DesignKind::central_composite}};
  for (auto const& [path, kind] : readers)
    if (text.has(path) && kind != design.kind)
      text.refuse(path,
                  fmt::format("is not used (Design/Kind = {}). Remove it?", design.kind_name));
  if (text.has("Design/Results filter") && design.results.empty())
    text.refuse("Design/Results filter", "filters nothing (Design/Results is empty). Remove it?");
}

std::vector<ResultsFilter> read_filter(StudyText const& text) {
  std::vector<ResultsFilter> filters;
  for (auto const& part : split_list(text.text("Design/Results filter"), ',')) {
    auto const halves = split_list(part, '=');
    if (halves.size() != 2)
      text.refuse("Design/Results filter", fmt::format("'{}' is no filter (one is COLUMN = TEXT). "
                                                       "Write simulator = LIGGGHTS?",
                                                       quote(part)));
    filters.push_back({halves[0], halves[1]});
  }
  return filters;
}

StudyDesign read_design(StudyText const& text, StudyFile const& study) {
  StudyDesign design{.kind = kind_of(text.text("Design/Kind")),
                     .kind_name = text.text("Design/Kind"),
                     .table = file_of(text, study.file, "Design/Table", text.text("Design/Table")),
                     .rows = split_list(text.text("Design/Rows"), ','),
                     .results =
                         file_of(text, study.file, "Design/Results", text.text("Design/Results")),
                     .filter = read_filter(text),
                     .replicates = static_cast<int>(text.count("Design/Replicates")),
                     .runs = static_cast<int>(text.count("Design/Runs")),
                     .centre_runs = static_cast<int>(text.count("Design/Centre runs")),
                     .axial_points = text.text("Design/Axial points"),
                     .seed = static_cast<std::uint64_t>(text.count("Design/Seed"))};
  refuse_unused(text, design);
  if (design.kind == DesignKind::table && design.table.empty())
    design.table = study.case_file.parent_path() / "settings.csv";
  return design;
}

void read_factors(StudyText const& text, StudyFile& study) {
  std::set<std::string> names;
  std::map<std::string, std::string> setters; // entry of the case -> who sets it
  for (auto const& value : study.common)
    setters[value.path] = fmt::format("'{}' ({})", common_section, value.where);
  for (int const number : text.numbers("Factor")) {
    auto const section = fmt::format("Factor {}", number);
    auto factor = read_factor(text, number, study.design.kind_name);
    if (!names.insert(factor.name).second)
      text.refuse(section + "/Name", "is another factor's name, too. Rename one?");
    for (auto const& entry : factor.entries) {
      auto const [setter, is_new] =
          setters.emplace(entry.path, fmt::format("factor '{}'", factor.name));
      if (!is_new)
        text.refuse(section + "/Entries",
                    fmt::format("'{}' is set by {}, too (one of them would be lost). Remove one?",
                                entry.path, setter->second));
    }
    study.factors.push_back(std::move(factor));
  }
  if (study.factors.empty() && study.design.kind != DesignKind::table)
    text.refuse("Design/Kind", "has no factor to vary (only a table can do without). Add "
                               "'subsection Factor 1'?");
  if (study.factors.size() < 2 && study.design.kind == DesignKind::central_composite)
    text.refuse("Design/Kind", "has one factor (corners and axial points need two). Take "
                               "full_factorial with five levels?");
}

} // namespace

StudyFactor const* StudyFile::factor(std::string_view name) const {
  auto const found = std::ranges::find(factors, name, &StudyFactor::name);
  return found == factors.end() ? nullptr : &*found;
}

std::string CostPlan::text(double at, StudyFile const& study) const {
  return is_of_grains ? fmt::format("{:.6g}", at) : study.factor(factor)->text(at);
}

StudyFile read_study(fs::path const& file) {
  VALIDATE(fs::exists(file),
           fmt::format("{}: does not exist (no such study file). Is it misspelt?", file.string()));
  StudyFile study{.text = StudyText(read_file(file), file.string()), .file = file, .title = {}};
  StudyText const& text = study.text;
  study.title = text.text("Title");
  text.needed("Case", "the case that the runs change");
  study.case_file = file_of(text, file, "Case", text.text("Case"));
  study.common = text.common();
  study.design = read_design(text, study);
  study.model = text.text("Model");
  read_factors(text, study);
  study.responses = read_responses(text, study);
  read_aims(text, study);
  if (study.title.empty())
    study.title = "Study of " + study.case_file.parent_path().filename().string();
  study.resolved_text = print_study(text, study);
  return study;
}

} // namespace coupling::study
