#include "tests/diagnosis/judge/judged_case.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace judging {
namespace {

using nlohmann::json;

constexpr double naming = 0.9;

json parsed(std::filesystem::path const& file) {
  std::ifstream stream(file);
  if (!stream)
    throw std::runtime_error(
        fmt::format("{}: cannot be read. Did the diagnosis of this case fail?", file.string()));
  return json::parse(stream);
}

std::optional<double> optional_number(json const& object, char const* key) {
  return object.contains(key) ? std::optional(object.at(key).get<double>()) : std::nullopt;
}

void read_named(json const& causes, Answer& answer) {
  answer.probability = 1.0;
  for (auto const& cause : causes) {
    double const p = cause.at("probability");
    if (p < naming && !answer.claim.empty())
      continue;
    if (answer.claim.empty() && !cause.at("parameters").empty()) {
      auto const& size = cause.at("parameters").front();
      answer.size = {.value = size.at("value"), .low = size.at("low"), .high = size.at("high")};
    }
    answer.claim.insert(cause.at("name").get<std::string>());
    answer.probability = std::min(answer.probability, p);
  }
}

/// "all" of a gain's channels; nothing without.
std::optional<json> all_channels(json const& gain) {
  for (auto const& channel : gain.value("channels", json::array()))
    if (channel.at("channel") == "all")
      return channel;
  return std::nullopt;
}

std::optional<Gain> read_gain(json const& gain) {
  auto const all = all_channels(gain);
  if (!all)
    return std::nullopt;
  Gain read{.before = all->at("before"),
            .after = all->at("after"),
            .of_placebo = {},
            .elpd = gain.at("elpd_difference"),
            .elpd_error = gain.at("elpd_error"),
            .coverage = all->at("coverage")};
  if (gain.contains("placebo") && gain.at("placebo").is_object())
    if (auto const placebo = all_channels(gain.at("placebo")))
      read.of_placebo = placebo->at("after");
  return read;
}

} // namespace

bool JudgedCase::has_truth() const {
  return !truth.causes.empty() && std::ranges::includes(answer.claim, truth.causes);
}
bool JudgedCase::is_unique() const {
  return is_named() && answer.claim.size() == 1 && !answer.is_incomplete;
}
bool JudgedCase::is_wrong() const {
  return !answer.claim.empty() && std::ranges::none_of(answer.claim, [&](auto const& claimed) {
    return truth.causes.contains(claimed);
  });
}
bool JudgedCase::has_spurious() const {
  return is_named() && !std::ranges::includes(truth.causes, answer.claim);
}

Answer read_answer(std::filesystem::path const& file) {
  auto const found = parsed(file);
  Answer answer;
  answer.verdict = found.at("verdict");
  answer.is_incomplete = found.value("incomplete", false);
  if (found.contains("alarm")) {
    answer.p_omnibus = optional_number(found.at("alarm"), "p_omnibus");
    answer.p_targeted = optional_number(found.at("alarm"), "p_targeted");
  }
  if (found.contains("gain") && found.at("gain").is_object())
    answer.gain = read_gain(found.at("gain"));
  if (answer.verdict == "named")
    read_named(found.at("causes"), answer);
  else if (answer.verdict == "undecided")
    answer.claim = found.at("group").get<std::set<std::string>>();
  else if (answer.verdict != "consistent" && answer.verdict != "unknown")
    throw std::runtime_error(
        fmt::format("{}: verdict '{}' is none of the contract's. Is it misspelt?", file.string(),
                    answer.verdict));
  return answer;
}

Truth read_truth(std::filesystem::path const& file) {
  auto const found = parsed(file);
  Truth truth{.kind = found.at("class"),
              .causes = {},
              .lambda = optional_number(found, "lambda"),
              .faintest = {},
              .separation = optional_number(found, "separation")};
  auto const set = found.at("observables").get<std::string>();
  truth.has_all_gauges = set != "A" && set != "F";
  for (auto const& effect : found.at("effects")) {
    truth.causes.insert(effect.at("name").get<std::string>());
    truth.size = effect.at("size");
    if (auto const lambda = optional_number(effect, "lambda"))
      truth.faintest = std::min(*lambda, truth.faintest.value_or(*lambda));
  }
  return truth;
}

std::vector<JudgedCase> read_cases(std::filesystem::path const& folder) {
  std::vector<JudgedCase> cases;
  for (auto const& entry : std::filesystem::directory_iterator(folder)) {
    auto const truth = entry.path() / "sealed" / "truth.json";
    if (!std::filesystem::exists(truth))
      continue;
    try {
      cases.push_back({.name = entry.path().filename().string(),
                       .truth = read_truth(truth),
                       .answer = read_answer(entry.path() / "diagnosis" / "diagnosis.json")});
    } catch (json::exception const& error) {
      throw std::runtime_error(fmt::format("{}: {}. Is it of the contract's form?",
                                           entry.path().string(), error.what()));
    }
  }
  std::ranges::sort(cases, {}, &JudgedCase::name);
  if (cases.empty())
    throw std::runtime_error(fmt::format(
        "{}: holds no cases (NAME/sealed/truth.json). Is it the right folder?", folder.string()));
  return cases;
}

} // namespace judging
