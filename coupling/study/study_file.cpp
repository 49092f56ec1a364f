#include "coupling/study/study_file.hpp"

#include "coupling/nearest_name.hpp"
#include "coupling/quote.hpp"
#include "coupling/record/atomic_file.hpp"
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

/// A file that an entry names, seen from the study file; empty where it names none.
fs::path file_of(StudyText const& text, fs::path const& study, std::string const& path) {
  auto const written = text.text(path);
  if (written.empty())
    return {};
  auto absolute = (fs::absolute(study).parent_path() / written).lexically_normal();
  if (!fs::is_regular_file(absolute))
    text.refuse(path, fmt::format("is no file (looked for {}; paths start at the study file). Is "
                                  "it misspelt?",
                                  absolute.string()));
  return absolute;
}

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
                     .table = file_of(text, study.file, "Design/Table"),
                     .rows = split_list(text.text("Design/Rows"), ','),
                     .results = file_of(text, study.file, "Design/Results"),
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

/// A value of a factor, by its name.
double factor_value(StudyText const& text, StudyFile const& study, std::string const& path,
                    std::string const& name, std::string const& value) {
  auto const* const factor = study.factor(name);
  std::vector<std::string> names;
  for (auto const& known : study.factors)
    names.push_back(known.name);
  if (factor == nullptr)
    text.refuse(path, fmt::format("'{}' is no factor of this study.{}", quote(name),
                                  did_you_mean(name, names, "Which one is meant?")));
  try {
    return value.empty() ? NAN : parse_quantity(value, factor->physical);
  } catch (dem::InvalidInput const& problem) {
    text.refuse(path, fmt::format("'{}' {}", quote(value), problem.what()));
  }
}

void read_calibration(StudyText const& text, StudyFile& study) {
  std::string const at = "Calibration/Held";
  for (auto const& part : split_list(text.text(at), ',')) {
    auto const halves = split_list(part, '=');
    if (halves.size() != 2 || halves[1].empty())
      text.refuse(at, fmt::format("'{}' holds no factor (one is NAME = VALUE). Write CED = 7e6 "
                                  "J/m^3?",
                                  quote(part)));
    auto const value = factor_value(text, study, at, halves[0], halves[1]);
    if (!study.calibration.held.emplace(halves[0], value).second)
      text.refuse(at, fmt::format("holds '{}' twice. Remove one?", halves[0]));
  }
  study.calibration.is_validated = text.truth("Calibration/Validation");
  study.calibration.validation_replicates =
      static_cast<int>(text.count("Calibration/Validation replicates"));
  if (study.calibration.is_validated && study.is_data())
    text.refuse("Calibration/Validation", "needs runs (Design/Results is read instead). Remove one "
                                          "of the two?");
  if (study.calibration.is_validated &&
      std::ranges::none_of(study.responses, [](auto const& r) { return r.target.has_value(); }))
    text.refuse("Calibration/Validation", "has nothing to aim at (no response has a Target). Add "
                                          "one?");
}

void read_extrapolation(StudyText const& text, StudyFile& study) {
  auto& part = study.extrapolation;
  part.factor = text.text("Extrapolation/Factor");
  part.responses = split_list(text.text("Extrapolation/Responses"), ',');
  if (part.factor.empty()) {
    for (auto const* path : {"Extrapolation/Value", "Extrapolation/Responses"})
      if (text.has(path))
        text.refuse(path, "is not used (Extrapolation/Factor is empty). Name the factor?");
    return;
  }
  auto const value = text.needed("Extrapolation/Value", "where to extrapolate to");
  factor_value(text, study, "Extrapolation/Factor", part.factor, "");
  part.value = factor_value(text, study, "Extrapolation/Value", part.factor, value);
  std::vector<std::string> names;
  for (auto const& response : study.responses)
    names.push_back(response.name);
  if (part.responses.empty())
    part.responses = names;
  for (auto const& name : part.responses)
    if (std::ranges::count(names, name) == 0)
      text.refuse("Extrapolation/Responses",
                  fmt::format("'{}' is no response of this study.{}", quote(name),
                              did_you_mean(name, names, "Which one is meant?")));
}

} // namespace

StudyFactor const* StudyFile::factor(std::string_view name) const {
  auto const found = std::ranges::find(factors, name, &StudyFactor::name);
  return found == factors.end() ? nullptr : &*found;
}

StudyFile read_study(fs::path const& file) {
  VALIDATE(fs::exists(file),
           fmt::format("{}: does not exist (no such study file). Is it misspelt?", file.string()));
  StudyFile study{.text = StudyText(read_file(file), file.string()), .file = file, .title = {}};
  StudyText const& text = study.text;
  study.title = text.text("Title");
  text.needed("Case", "the case that the runs change");
  study.case_file = file_of(text, file, "Case");
  study.common = text.common();
  study.design = read_design(text, study);
  study.model = text.text("Model");
  read_factors(text, study);
  study.responses = read_responses(text, study);
  read_calibration(text, study);
  read_extrapolation(text, study);
  study.cost_factor = text.text("Cost/Factor");
  if (!study.cost_factor.empty())
    factor_value(text, study, "Cost/Factor", study.cost_factor, "");
  if (study.title.empty())
    study.title = "Study of " + study.case_file.parent_path().filename().string();
  study.resolved_text = print_study(text, study);
  return study;
}

} // namespace coupling::study
