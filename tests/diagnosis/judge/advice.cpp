#include "tests/diagnosis/judge/advice.hpp"

#include "tests/diagnosis/judge/rates.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <map>

namespace judging {
namespace {

using nlohmann::json;

/// What the diagnosis calls a measurement, and the generator.
std::map<std::string, std::string> const made_as = {
    {"height of the compact, by caliper", "compact_height"},
    {"mass of the compact, by balance", "compact_mass"},
    {"diameter of the die, by bore gauge", "compact_diameter"},
    {"gap between the punches at the largest force, by gauge", "gap_at_peak"},
    {"load cell under a dead weight of 10 kN", "dead_weight"},
    {"a dwell of 60 s at the end gap", "dwell_60"},
    {"a dwell of 600 s at the end gap", "dwell_600"},
    {"a run at 25 times the speed", "fast"},
    {"a run at a fifth of the speed", "slow"},
    {"a run to an end gap 5 % larger", "wider"}};

json parsed(std::filesystem::path const& file) {
  std::ifstream stream(file);
  return json::parse(stream);
}

} // namespace

std::vector<Advised> advised_cases(std::filesystem::path const& folder) {
  std::vector<Advised> all;
  for (auto const& one : read_cases(folder)) {
    if (one.truth.kind != "single" || one.answer.verdict != "undecided" || !one.has_truth())
      continue;
    auto const advice =
        parsed(folder / one.name / "diagnosis" / "diagnosis.json").at("next_measurement");
    if (advice.empty() || !advice[0].at("enough").get<bool>())
      continue;
    auto const made = made_as.find(advice[0].at("name").get<std::string>());
    if (made == made_as.end())
      continue;
    auto const truth = parsed(folder / one.name / "sealed" / "truth.json");
    all.push_back({.name = one.name,
                   .seed = truth.at("seed").dump(),
                   .observables = truth.at("observables"),
                   .cause = *one.truth.causes.begin(),
                   .size = truth.at("effects")[0].at("size").dump(),
                   .measurement = made->second});
  }
  return all;
}

BarResult hold_advice(std::span<JudgedCase const> again, double level) {
  Rates hold(again, level);
  hold.at_least(
      "B8", "named, with what was recommended", 0.9, [](auto const&) { return true; },
      [](auto const& c) { return c.is_right_alone(); });
  return hold.results.front();
}

} // namespace judging
