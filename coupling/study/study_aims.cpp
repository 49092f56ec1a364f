#include "coupling/study/study_aims.hpp"

#include "coupling/case_value.hpp"
#include "coupling/nearest_name.hpp"
#include "coupling/quote.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace coupling::study {
namespace {

namespace fs = std::filesystem;

/// A value of a factor, by its name.
double factor_value(StudyText const& text, StudyFile const& study, std::string const& path,
                    std::string const& name, std::string const& value) {
  auto const* const factor = study.factor(name);
  std::vector<std::string> names;
  names.reserve(study.factors.size());
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

std::vector<std::string> names_of(std::vector<StudyResponse> const& responses) {
  std::vector<std::string> names;
  names.reserve(responses.size());
  for (auto const& response : responses)
    names.push_back(response.name);
  return names;
}

/// Names of an entry's list, each one of `known`.
std::vector<std::string> read_names(StudyText const& text, std::string const& path,
                                    std::vector<std::string> const& known,
                                    std::string const& what) {
  auto names = split_list(text.text(path), ',');
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (std::ranges::count(known, *name) == 0)
      text.refuse(path, fmt::format("'{}' is no {}.{}", quote(*name), what,
                                    did_you_mean(*name, known, "Which one is meant?")));
    if (std::find(names.begin(), name, *name) != name)
      text.refuse(path, fmt::format("names '{}' twice. Name it once?", *name));
  }
  return names;
}

/// Entries that nothing reads.
void refuse_unused(StudyText const& text, std::initializer_list<char const*> paths,
                   std::string_view why) {
  for (auto const* path : paths)
    if (text.has(path))
      text.refuse(path, why);
}

PackingPlan read_packing(StudyText const& text) {
  text.needed("Extrapolation/Fine share", "packing_model mixes fines and coarse grains");
  auto const number = [&](std::string const& path) {
    return parse_number(*find_study_entry(path), text.text(path));
  };
  PackingPlan plan{.fine_share = number("Extrapolation/Fine share"),
                   .compaction_index = number("Extrapolation/Compaction index"),
                   .coarse = {}};
  std::string const path = "Extrapolation/Coarse sizes";
  if (!text.has(path))
    return plan;
  plan.coarse = parse_size_classes(*find_study_entry(path), text.text(path));
  double sum = 0.0;
  for (auto const& one : plan.coarse)
    sum += one.mass_fraction;
  if (std::abs(sum - 1.0) > 1e-6)
    text.refuse(path, fmt::format("has shares that make {:.6g} % (the coarse grains are 100 %). Is "
                                  "a class missing?",
                                  100.0 * sum));
  return plan;
}

void read_forms(StudyText const& text, ExtrapolationPlan& part) {
  static std::vector<std::string> const known{"linear", "quadratic", "logarithmic", "power",
                                              "packing_model"};
  std::string const path = "Extrapolation/Forms";
  text.needed(path, "the curves that carry the trend on");
  part.forms =
      read_names(text, path, known, fmt::format("form (there are: {})", fmt::join(known, ", ")));
  if (std::ranges::count(part.forms, "packing_model") > 0)
    part.packing = read_packing(text);
  else
    refuse_unused(text,
                  {"Extrapolation/Fine share", "Extrapolation/Compaction index",
                   "Extrapolation/Coarse sizes"},
                  "is not used (packing_model is not among Extrapolation/Forms). Add it there?");
}

void read_extrapolation(StudyText const& text, StudyFile& study) {
  auto& part = study.extrapolation;
  part.factor = text.text("Extrapolation/Factor");
  if (part.factor.empty())
    return refuse_unused(text,
                         {"Extrapolation/Value", "Extrapolation/Responses", "Extrapolation/Forms",
                          "Extrapolation/Fine share", "Extrapolation/Compaction index",
                          "Extrapolation/Coarse sizes"},
                         "is not used (Extrapolation/Factor is empty). Name the factor?");
  auto const value = text.needed("Extrapolation/Value", "where to extrapolate to");
  factor_value(text, study, "Extrapolation/Factor", part.factor, "");
  part.value = factor_value(text, study, "Extrapolation/Value", part.factor, value);
  auto const names = names_of(study.responses);
  part.responses = read_names(text, "Extrapolation/Responses", names, "response of this study");
  if (part.responses.empty())
    part.responses = names;
  read_forms(text, part);
}

void read_cost(StudyText const& text, StudyFile& study) {
  auto& cost = study.cost;
  std::string const at = "Cost/Predict at";
  cost.factor = text.text("Cost/Factor");
  if (cost.factor.empty())
    return refuse_unused(text, {at.c_str()},
                         "is not used (Cost/Factor is empty). Name the factor?");
  cost.is_of_grains = cost.factor == grains_word && study.factor(cost.factor) == nullptr;
  if (!cost.is_of_grains)
    factor_value(text, study, "Cost/Factor", cost.factor, "");
  for (auto const& part : split_list(text.text(at), ',')) {
    double value = NAN;
    try {
      value = cost.is_of_grains ? parse_quantity(part, Physical::ratio)
                                : factor_value(text, study, at, cost.factor, part);
    } catch (dem::InvalidInput const& problem) {
      if (!cost.is_of_grains)
        throw; // it names the place already
      text.refuse(at, fmt::format("'{}' {}", quote(part), problem.what()));
    }
    if (!(value > 0.0))
      text.refuse(at, fmt::format("'{}' is not above 0 (a power law has no value there). Which "
                                  "size is meant?",
                                  quote(part)));
    cost.predict_at.push_back(value);
  }
  if (cost.predict_at.empty() && cost.factor == study.extrapolation.factor)
    cost.predict_at = {study.extrapolation.value};
}

void read_references(StudyText const& text, StudyFile& study) {
  auto& part = study.references;
  std::string const at = "Reference/Tables", rows = "Reference/Rows";
  for (auto const& file : split_list(text.text(at), ','))
    part.tables.push_back(file_of(text, study.file, at, file));
  if (part.tables.empty())
    return refuse_unused(text, {rows.c_str()},
                         "is not used (Reference/Tables is empty). Name the tables?");
  for (auto const& pair : split_list(text.text(rows), ',')) {
    auto const halves = split_list(pair, '=');
    if (halves.size() != 2 || halves[0].empty() || halves[1].empty())
      text.refuse(rows, fmt::format("'{}' names no row (one is SETUP = ROW). Write E1375_CED3e6 = "
                                    "E1375_CED3_D300?",
                                    quote(pair)));
    if (!part.rows.emplace(halves[0], halves[1]).second)
      text.refuse(rows, fmt::format("names '{}' twice. Name it once?", quote(halves[0])));
  }
}

} // namespace

fs::path file_of(StudyText const& text, fs::path const& study, std::string const& path,
                 std::string const& written) {
  if (written.empty())
    return {};
  auto absolute = (fs::absolute(study).parent_path() / written).lexically_normal();
  if (!fs::is_regular_file(absolute))
    text.refuse(path, fmt::format("is no file (looked for {}; paths start at the study file). Is "
                                  "it misspelt?",
                                  absolute.string()));
  return absolute;
}

void read_aims(StudyText const& text, StudyFile& study) {
  read_calibration(text, study);
  read_extrapolation(text, study);
  read_cost(text, study);
  read_references(text, study);
}

} // namespace coupling::study
