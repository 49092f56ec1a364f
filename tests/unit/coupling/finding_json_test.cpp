// diagnosis.json against the outward contract, and from the statistics to names.
#include "coupling/finding/finding_json.hpp"
#include "coupling/finding/finding_of.hpp"
#include "tests/support/sample_finding.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/coupling/diagnosis_press.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace coupling::finding {
namespace {

using Json = nlohmann::json;
using namespace diagnosis_support;

Json parsed(Finding const& finding) {
  return Json::parse(diagnosis_json(finding));
}

std::vector<std::string> names_in(Json const& list, char const* key) {
  std::vector<std::string> names;
  for (auto const& one : list)
    names.push_back(one.at(key));
  return names;
}

/// The contract's own rules; ../shared/check/contract holds the same.
void expect_contract(Json const& json) {
  for (auto const* key : {"verdict", "misfit", "causes", "group", "next_measurement", "gain",
                          "detectable", "tolerances"})
    EXPECT_TRUE(json.contains(key)) << key;
  std::string const verdict = json["verdict"];
  EXPECT_TRUE(
      (std::set<std::string>{"consistent", "named", "undecided", "unknown"}).contains(verdict));
  for (auto const& cause : json["causes"])
    for (auto const& parameter : cause.at("parameters"))
      for (auto const* key : {"value", "low", "high"})
        EXPECT_TRUE(parameter.at(key).is_number()) << key;
  EXPECT_FALSE(verdict == "named" && json["causes"].empty());
  EXPECT_FALSE(verdict == "undecided" && json["group"].size() < 2);
}

TEST(FindingJson, KeepsTheContractForEveryVerdict) {
  for (auto const& finding : {sample::named(), sample::undecided(), sample::unknown(),
                              sample::consistent(), Finding{.verdict = "consistent"}})
    expect_contract(parsed(finding));
}

TEST(FindingJson, HoldsBeforeTheContractsOwnChecker) {
  std::filesystem::path const contract = PRESSCHECK_SOURCE_DIR "/../shared/check/contract";
  if (!std::filesystem::exists(contract))
    GTEST_SKIP() << "this copy of the project has no contract beside it";
  support::ScratchFolder const folder;
  for (auto const& finding :
       {sample::named(), sample::undecided(), sample::unknown(), sample::consistent()}) {
    support::put_bytes(folder / "diagnosis.json", diagnosis_json(finding));
    auto const call = contract.string() + " diagnosis " + (folder / "diagnosis.json").string() +
                      " > " + (folder / "said").string();
    EXPECT_EQ(std::system(call.c_str()), 0) << support::bytes_of(folder / "said");
  }
}

TEST(FindingJson, HoldsEveryNumberOfACause) {
  auto const json = parsed(sample::named());
  EXPECT_EQ(json["verdict"], "named");
  EXPECT_EQ(json["incomplete"], false);
  auto const& cause = json["causes"][0];
  EXPECT_EQ(cause["name"], "frame_compliance");
  EXPECT_EQ(cause["probability"], 0.97);
  EXPECT_EQ(cause["log_evidence"], 1012.4);
  EXPECT_EQ(cause["named"], true);
  auto const& size = cause["parameters"][0];
  EXPECT_EQ(size["value"], 18e-9);
  EXPECT_EQ(size["low"], 17.1e-9);
  EXPECT_EQ(size["high"], 19.2e-9);
  EXPECT_EQ(size["unit"], "m/N");
  EXPECT_EQ(json["causes"][1]["parameters"][0]["open_high"], true);
  auto const& cell = json["misfit"][0];
  EXPECT_EQ(cell["channel"], "upper_punch_force");
  EXPECT_EQ(cell["phase"], "loading");
  EXPECT_EQ(cell["size"], -21.3);
  EXPECT_EQ(cell["p"], 2e-9);
  EXPECT_EQ(cell["sign"], "negative");
  EXPECT_EQ(cell["shape"], "measured falls against the model");
}

TEST(FindingJson, PutsThePlaceboBesideTheGain) {
  auto const gain = parsed(sample::named())["gain"];
  EXPECT_EQ(names_in(gain["channels"], "channel"),
            (std::vector<std::string>{"upper_punch_force", "compact_height", "all"}));
  EXPECT_EQ(gain["channels"][0]["before"], 912.0);
  EXPECT_EQ(gain["channels"][0]["coverage"], 0.95);
  EXPECT_TRUE(gain["channels"][1]["low"].is_null()) << "fewer than three runs have no interval";
  EXPECT_EQ(gain["elpd_difference"], 341.0);
  EXPECT_EQ(gain["placebo"]["causes"][0], "force_lag");
  EXPECT_TRUE(parsed(sample::undecided())["gain"].is_null());
}

TEST(FindingJson, ForetellsTheNextMeasurement) {
  auto const next = parsed(sample::undecided())["next_measurement"];
  EXPECT_EQ(next[0]["separation_after"], 9.8);
  EXPECT_EQ(next[0]["enough"], true);
  EXPECT_EQ(next[0]["predictions"][1]["cause"], "force_lag");
  EXPECT_EQ(next[0]["predictions"][1]["value"][0], 310.0);
  EXPECT_EQ(next[0]["predictions"][1]["sd"][0], 28.0);
  // Force and pressure do not share a unit.
  ASSERT_EQ(next[1]["readings"].size(), 2u);
  EXPECT_EQ(next[1]["readings"][0]["unit"], "m");
  EXPECT_EQ(next[1]["readings"][1]["channel"], "lower_punch_force");
  EXPECT_EQ(next[1]["readings"][1]["unit"], "N");
  EXPECT_EQ(next[1]["readings"][1]["phase"], "unloading");
  EXPECT_EQ(next[1]["readings"][1]["gap"], 8.2e-3);
}

TEST(FindingJson, WritesNoNumberThatIsNone) {
  auto finding = sample::unknown();
  EXPECT_TRUE(parsed(finding)["detectable"][5]["size"].is_null());
  EXPECT_TRUE(parsed(finding)["unknown"]["forms"][1]["width"].is_null());
  finding = sample::named();
  finding.causes[1].parameters[0].high = std::numeric_limits<double>::infinity();
  finding.decisions = {"bad byte \xff"}; // of a raw file
  expect_contract(parsed(finding));
  EXPECT_EQ(parsed(finding)["causes"][1]["parameters"][0]["high"],
            std::numeric_limits<double>::max());
}

// --- from the statistics ----------------------------------------------------------------------

struct Diagnosed {
  ToyPress press;
  Observations data;
  ErrorSources errors;
  DiagnosisSettings settings;
  Diagnosis found;

  Diagnosed(ToyPress p, HiddenTruth const& truth, std::uint64_t seed)
      : press(std::move(p)), data(hidden_data(press, truth, seed)), errors(toy_errors()),
        found(diagnose(data, press, errors, settings)) {}
  FindingSources sources() const {
    return {.model = press, .observations = data, .errors = errors, .settings = settings};
  }
};

TEST(FindingOf, NamesTheCauseWithItsSizeAndInterval) {
  Diagnosed const one({}, {.sizes = {{"frame_compliance", 0.8}}}, 77);
  auto const finding = finding_of(one.found, one.sources());
  EXPECT_EQ(finding.verdict, "named");
  ASSERT_FALSE(finding.causes.empty());
  auto const& cause = finding.causes.front();
  EXPECT_EQ(cause.name, "frame_compliance");
  EXPECT_TRUE(cause.is_named);
  EXPECT_EQ(cause.probability, one.found.estimates[0].probability);
  EXPECT_EQ(cause.size(), one.found.estimates[0].size.value);
  EXPECT_EQ(cause.parameters[0].low, one.found.estimates[0].size.low);
  EXPECT_EQ(cause.parameters[0].high, one.found.estimates[0].size.high);
  EXPECT_EQ(cause.parameters[0].unit, "m/N");
  EXPECT_GT(cause.log_evidence, 0.0);
  EXPECT_TRUE(cause.plausibility.starts_with("plausible: 0.")) << cause.plausibility;
  expect_contract(parsed(finding));
}

TEST(FindingOf, CurvesHoldEveryRowOnce) {
  Diagnosed const one({}, {.sizes = {{"frame_compliance", 1.0}}}, 77);
  auto sources = one.sources();
  sources.places.time = VectorXd::LinSpaced(one.data.size(), 0.0, 100.0);
  auto const finding = finding_of(one.found, sources);
  std::size_t rows = 0;
  for (auto const& curve : finding.curves) {
    rows += curve.measured.size();
    for (auto const* list : {&curve.time, &curve.calibrated, &curve.extended, &curve.sd})
      EXPECT_EQ(list->size(), curve.measured.size());
    EXPECT_EQ(curve.phase.size(), curve.measured.size());
    EXPECT_TRUE(curve.gap.empty());
  }
  EXPECT_EQ(rows, static_cast<std::size_t>(one.data.size()));
  EXPECT_EQ(finding.curves[0].unit, "N");
  EXPECT_EQ(finding.curves[0].calibrated[3], one.found.baseline.predicted[3]);
  EXPECT_EQ(finding.curves[0].extended[3], one.found.selection.best().fit.predicted[3]);
  sources.places.gap = VectorXd::Zero(3);
  EXPECT_NE(message_of([&] { finding_of(one.found, sources); }).find("are 3 for"),
            std::string::npos);
}

TEST(FindingOf, AGroupHasTwoAtLeast) {
  auto press = with_fixed_modulus(ToyPress{});
  press.gauges = Gauges::upper;
  press.parameters[1].sd = 1e3;
  Diagnosed const one(press, {.sizes = {{"force_gain", 1.5}}, .young = 0.0, .cohesion = 0.0}, 501);
  auto finding = finding_of(one.found, one.sources());
  EXPECT_EQ(finding.verdict, "undecided");
  EXPECT_EQ(finding.group, (std::vector<std::string>{"force_gain", "young_modulus"}));
  for (auto const& name : finding.group)
    EXPECT_NE(find_cause(finding, name), nullptr) << name;
  // A name that does not win on held-out runs is a group of its own.
  Diagnosed gated({}, {.sizes = {{"frame_compliance", 1.0}}}, 77);
  gated.found.verdict = pass_gate(gated.found.verdict, 0.0, 1.0);
  EXPECT_EQ(gated.found.verdict.group.size(), 1u);
  finding = finding_of(gated.found, gated.sources());
  expect_contract(parsed(finding));
  EXPECT_TRUE(named_causes(finding).empty());
}

TEST(FindingOf, AParameterFarFromItsSheetIsACause) {
  ToyPress press;
  press.parameters[0].sd = 0.1;
  Diagnosed const one(press, {.sizes = {}, .young = 4.0}, 510);
  ASSERT_FALSE(one.found.tests.is_alarm);
  auto const finding = finding_of(one.found, one.sources());
  ASSERT_EQ(finding.verdict, "named");
  auto const& cause = finding.causes.at(0);
  EXPECT_EQ(cause.name, "young_modulus");
  EXPECT_TRUE(cause.is_named && cause.is_calibrated);
  // Hidden: 4 sd of 0.1 in ln E, exp(0.4) - 1.
  EXPECT_NEAR(cause.size(), std::expm1(0.4), 0.05);
  EXPECT_LT(cause.parameters[0].low, cause.size());
  EXPECT_GT(cause.parameters[0].high, cause.size());
  expect_contract(parsed(finding));
}

TEST(FindingOf, WhatIsProbableAndNotNamedStandsApart) {
  Diagnosed one({}, {.sizes = {{"frame_compliance", 0.8}}}, 77);
  one.found.selection.inclusion[1] = 0.95;
  one.found.selection.inclusion[3] = 0.5;
  auto const finding = finding_of(one.found, one.sources());
  EXPECT_EQ(finding.not_claimed, std::vector<std::string>{"gap_offset"});
  EXPECT_EQ(find_cause(finding, "gap_offset"), nullptr);
  ASSERT_NE(find_cause(finding, "force_offset"), nullptr);
  EXPECT_EQ(finding.causes.front().name, "frame_compliance");
  EXPECT_EQ(named_causes(finding).size(), 1u);
}

TEST(FindingOf, ABentBaselineIsNoCauseUnderAnAlarm) {
  Diagnosed one({}, {.sizes = {{"frame_compliance", 0.8}}}, 77);
  one.found.verdict.parameters = {{.parameter = 0, .value = 6e8, .z = 4.0, .equivalent = {1}}};
  auto const finding = finding_of(one.found, one.sources());
  EXPECT_EQ(find_cause(finding, "young_modulus"), nullptr);
  EXPECT_TRUE(finding.group.empty());
}

TEST(FindingOf, CalibratedValuesHaveTheSpreadOfAFit) {
  // Of sets that differ by their noise alone, the values scatter as the sd says.
  std::vector<double> values;
  double sd = 0.0;
  for (std::uint64_t seed = 900; seed < 930; ++seed) {
    Diagnosed const one({}, {.sizes = {}}, seed);
    auto const value = finding_of(one.found, one.sources()).calibrated.at(0);
    values.push_back(value.value);
    sd += value.sd / 30.0;
  }
  double mean = 0.0, spread = 0.0;
  for (double const v : values)
    mean += v / 30.0;
  for (double const v : values)
    spread += (v - mean) * (v - mean) / 29.0;
  // chi with 29 degrees of freedom: 0.6 to 1.5 but once in a thousand.
  EXPECT_GT(std::sqrt(spread), 0.6 * sd);
  EXPECT_LT(std::sqrt(spread), 1.5 * sd);
}

TEST(FindingOf, StatesInstrumentsWithTheirSource) {
  Diagnosed const one({}, {.sizes = {}}, 3);
  auto const finding = finding_of(one.found, one.sources());
  EXPECT_EQ(finding.verdict, "consistent");
  auto const force =
      std::ranges::find(finding.tolerances, "upper_punch_force/sd", &StatedError::name);
  ASSERT_NE(force, finding.tolerances.end());
  EXPECT_EQ(force->value, one.errors.channels[0].sd);
  EXPECT_EQ(force->unit, "N");
  EXPECT_EQ(finding.tolerances.front().name, "model_share");
  for (auto const& stated : finding.tolerances)
    EXPECT_FALSE(stated.source.empty()) << stated.name;
}

} // namespace
} // namespace coupling::finding
