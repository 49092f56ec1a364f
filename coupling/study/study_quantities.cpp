#include "coupling/study/study_quantities.hpp"

#include "coupling/case_value.hpp"
#include "coupling/compare/value_table.hpp"
#include "coupling/nearest_name.hpp"
#include "coupling/record/atomic_file.hpp"
#include "coupling/record/summary_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <limits>
#include <set>
#include <utility>

namespace coupling::study {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::pair<std::string_view, std::string_view>, 5> endings{
    {{"_N", "N"}, {"_m", "m"}, {"_s", "s"}, {"_Pa", "Pa"}, {"_J", "J"}}};

/// `max_force_N` -> max_force, N.
std::pair<std::string, std::string> split_key(std::string const& key) {
  if (key == "wall_seconds")
    return {key, "s"};
  for (auto const& [ending, unit] : endings)
    if (key.ends_with(ending) && key.size() > ending.size())
      return {key.substr(0, key.size() - ending.size()), std::string(unit)};
  return {key, "1"};
}

StudyValues values_in(Json const& summary) {
  StudyValues values;
  for (auto const& [key, value] : summary.items()) {
    if (!value.is_number() && !value.is_null())
      continue;
    auto const [name, unit] = split_key(key);
    values[name] = {
        value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>(), unit};
  }
  return values;
}

/// Quantities that the runs of a study will have, or those that its table of results has.
StudyValues known_quantities(StudyFile const& study) {
  if (!study.is_data())
    return values_in(Json::parse(summary_json(Summary{})));
  StudyValues values;
  for (auto const& row : read_value_table(study.design.results))
    for (auto const& value : row.values)
      values[value.name] = {value.value, value.unit};
  return values;
}

/// A target in SI. Units that no entry of a case measures are not known: a bare number is SI.
double read_target(StudyText const& text, std::string const& path, std::string const& unit) {
  static std::map<std::string, Physical> const physical{
      {"1", Physical::ratio},  {"N", Physical::force},    {"m", Physical::length},
      {"s", Physical::time},   {"Pa", Physical::modulus}, {"kg", Physical::mass},
      {"m/s", Physical::speed}};
  auto const known = physical.find(unit);
  try {
    return parse_quantity(text.text(path),
                          known == physical.end() ? Physical::ratio : known->second);
  } catch (dem::InvalidInput const& problem) {
    text.refuse(path, problem.what());
  }
}

StudyResponse read_response(StudyText const& text, std::string const& section,
                            StudyValues const& known) {
  StudyResponse response{.name = text.needed(section + "/Name", "tables call it by that"),
                         .quantity = text.needed(section + "/Quantity", "what to take of a run"),
                         .where = text.where(section + "/Quantity"),
                         .unit = {},
                         .target = {},
                         .uncertainty = {},
                         .observed = {}};
  auto found = known.find(response.quantity);
  if (found == known.end())
    found = known.find(split_key(response.quantity).first);
  if (found == known.end()) {
    std::vector<std::string> names;
    for (auto const& [name, value] : known)
      names.push_back(name);
    text.refuse(section + "/Quantity",
                fmt::format("is no number that the results have ({}).{}", fmt::join(names, ", "),
                            did_you_mean(response.quantity, names, "Take one of them?")));
  }
  response.quantity = found->first;
  response.unit = found->second.unit;
  auto const target = section + "/Target", uncertainty = section + "/Target uncertainty";
  if (!text.text(target).empty())
    response.target = read_target(text, target, response.unit);
  if (!text.text(uncertainty).empty()) {
    response.uncertainty = read_target(text, uncertainty, response.unit);
    if (!response.target)
      text.refuse(uncertainty, "is not used (there is no Target). Add the target?");
    if (!(*response.uncertainty > 0.0))
      text.refuse(uncertainty, "is not above 0. Leave it out if it is not known?");
  }
  auto const observed = section + "/Observed", scale = section + "/Reference scale";
  if (!text.text(observed).empty() && response.target)
    text.refuse(observed, "is not used (Target says what was measured). Remove one of the two?");
  response.observed = text.text(observed).empty()
                          ? response.target
                          : std::optional(read_target(text, observed, response.unit));
  response.reference_scale = parse_number(*find_study_entry(scale), text.text(scale));
  return response;
}

} // namespace

StudyValues values_of_summary(std::filesystem::path const& file) {
  try {
    return values_in(Json::parse(read_file(file)));
  } catch (Json::exception const& error) {
    throw dem::InvalidInput(
        fmt::format("{}: cannot be understood: {} (it is no summary of a run). Was it edited?",
                    file.string(), error.what()));
  }
}

std::vector<StudyResponse> read_responses(StudyText const& text, StudyFile const& study) {
  std::vector<StudyResponse> responses;
  std::set<std::string> names;
  auto const known = known_quantities(study);
  for (int const number : text.numbers("Response")) {
    auto const section = fmt::format("Response {}", number);
    responses.push_back(read_response(text, section, known));
    if (!names.insert(responses.back().name).second)
      text.refuse(section + "/Name", "is another response's name, too. Rename one?");
  }
  VALIDATE(!responses.empty() || study.factors.empty(),
           fmt::format("{}: has factors but no response (nothing could be fitted to them). Add "
                       "'subsection Response 1'?",
                       text.name()));
  return responses;
}

} // namespace coupling::study
