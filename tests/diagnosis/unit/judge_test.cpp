#include "tests/diagnosis/broken/broken.hpp"
#include "tests/diagnosis/hide/case_files.hpp"
#include "tests/diagnosis/judge/advice.hpp"
#include "tests/diagnosis/judge/binomial.hpp"
#include "tests/support/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace {

using Json = nlohmann::ordered_json;

// Diagnosis note 3.3: the 99 % binomial limit for a true 1 % of 400 is 9; P(X >= 10) = 0.0077,
// P(X >= 9) = 0.0208. And P(X <= 11 | 20, 0.85) = 0.0013, P(X <= 12) = 0.0059, P(X <= 13) = 0.0219.
TEST(Binomial, AllowsWhatATrueRateDoes) {
  EXPECT_EQ(judging::most_allowed(400, 0.01), 9);
  EXPECT_EQ(judging::least_allowed(20, 0.85), 13);
  EXPECT_EQ(judging::most_allowed(16, 0.02), 2);
  EXPECT_EQ(judging::most_allowed(16, 0.02, 1e-4), 4);   // P(X >= 4) = 2.5e-4, P(X >= 5) = 1e-5
  EXPECT_EQ(judging::least_allowed(20, 0.85, 1e-4), 10); // P(X <= 10) = 2.5e-4, P(X <= 9) = 4e-5
  EXPECT_EQ(judging::most_allowed(0, 0.01), 0);
  EXPECT_EQ(judging::least_allowed(0, 0.95), 0);
  EXPECT_EQ(judging::least_allowed(1, 0.95), 0); // P(0) = 0.05: one miss says nothing
  EXPECT_EQ(judging::most_allowed(1, 0.01), 1);  // P(1) = 0.01 is just likely enough
}

/// Cases with the truth that a small set has; the data of one clean and one hidden case serve all.
class SmallSet : public testing::Test {
protected:
  static void SetUpTestSuite() {
    shared_ = std::make_unique<support::ScratchFolder>();
    for (int k = 0; k < 4; ++k) {
      hidden::Wish const wish{.seed = static_cast<std::uint64_t>(k),
                              .kind = k < 2 ? hidden::CaseClass::clean : hidden::CaseClass::single,
                              .observables = hidden::Observables::A};
      write_case(draw_case(wish), *shared_ / fmt::format("{}", k), hidden::Foretold::nothing);
    }
  }
  static void TearDownTestSuite() { shared_.reset(); }

  SmallSet() {
    for (int k = 0; k < 40; ++k) {
      auto const kind = k < 12 ? "clean" : k < 28 ? "single" : k < 34 ? "double" : "unknown";
      add(fmt::format("{:02}", k), kind, k);
    }
  }

  void add(std::string const& name, std::string const& kind, int k) {
    auto const folder = scratch_ / name;
    std::filesystem::create_directories(folder / "sealed");
    std::filesystem::create_directories(folder / "diagnosis");
    Json truth = {{"class", kind}, {"observables", "D"}, {"lambda", 16.2}, {"separation", 9.0}};
    truth["effects"] = Json::array();
    static constexpr char const* known[] = {"frame_compliance", "wall_friction", "mass_error",
                                            "breakage"};
    double const size = 1.0 + 0.1 * (k % 3);
    if (kind == "single" || kind == "double")
      truth["effects"].push_back({{"name", known[k % 4]}, {"size", size}});
    if (kind == "double")
      truth["effects"].push_back({{"name", known[(k + 1) % 4]}, {"size", size}});
    if (kind == "unknown")
      truth["effects"].push_back({{"name", "stick_slip"}, {"size", size}});
    std::ofstream(folder / "sealed/truth.json") << truth;
    std::ofstream(folder / "good.json") << good_answer(truth);
  }

  /// What a diagnoser says that sees the truth through a haze of 5 %.
  static Json good_answer(Json const& truth) {
    std::string const kind = truth["class"];
    Json answer = {{"verdict", kind == "clean"     ? "consistent"
                               : kind == "unknown" ? "unknown"
                                                   : "named"},
                   {"causes", Json::array()},
                   {"group", Json::array()}};
    if (answer["verdict"] != "named")
      return answer;
    for (auto const& effect : truth["effects"]) {
      double const size = 1.02 * effect["size"].get<double>();
      Json const parameter = {
          {"name", "size"}, {"value", size}, {"low", 0.9 * size}, {"high", 1.1 * size}};
      answer["causes"].push_back({{"name", effect["name"]},
                                  {"probability", 0.97},
                                  {"parameters", Json::array({parameter})}});
    }
    return answer;
  }

  bool passes(std::string_view diagnoser) {
    int k = 0;
    for (auto const& name : names()) {
      auto const folder = scratch_ / name;
      // Clean data for the clean, the others' for the others.
      auto const data = *shared_ / fmt::format("{}/data", (k < 12 ? 0 : 2) + k % 2);
      auto const answer = diagnoser == "good"
                              ? Json::parse(support::bytes_of(folder / "good.json"))
                              : broken::diagnose(diagnoser, data, folder / "good.json");
      std::ofstream(folder / "diagnosis/diagnosis.json") << answer;
      ++k;
    }
    bool holds = true;
    for (auto const& bar : judging::hold_bars(judging::read_cases(scratch_.path())))
      holds = holds && bar.holds;
    return holds;
  }

  std::vector<std::string> names() const {
    auto all = scratch_.names();
    std::ranges::sort(all);
    return all;
  }

  support::ScratchFolder scratch_;
  inline static std::unique_ptr<support::ScratchFolder> shared_;
};

TEST(Bars, CountPairsOfWhichBothShow) {
  auto const pairs = [](double faintest) {
    judging::JudgedCase const pair{.name = "pair",
                                   .truth = {.kind = "double",
                                             .has_all_gauges = true,
                                             .causes = {"a", "b"},
                                             .size = 1.0,
                                             .lambda = 30.0,
                                             .faintest = faintest,
                                             .separation = {}},
                                   .answer = {}};
    int n = 0;
    for (auto const& bar : judging::hold_bars(std::span(&pair, 1)))
      n += bar.bar == "B9" ? bar.cases : 0;
    return n;
  };
  EXPECT_EQ(pairs(7.0), 0);
  EXPECT_EQ(pairs(25.0), 3); // a bar each
}

/// Of one kind of bar: how many of 40 such cases it counts, and whether all of its lines hold.
std::pair<int, bool> counted(char const* bar, judging::JudgedCase const& one) {
  std::vector<judging::JudgedCase> const cases(40, one);
  std::pair<int, bool> found{0, true};
  for (auto const& result : judging::hold_bars(cases))
    if (result.bar == bar)
      found = {std::max(found.first, result.cases), found.second && result.holds};
  return found;
}

TEST(Bars, HoldGainsOnHeldOutRuns) {
  judging::JudgedCase const good{.name = "good",
                                 .truth = {.kind = "single",
                                           .has_all_gauges = true,
                                           .causes = {"a"},
                                           .size = 1.0,
                                           .lambda = 16.0,
                                           .faintest = {},
                                           .separation = 9.0},
                                 .answer = {.verdict = "named",
                                            .is_incomplete = false,
                                            .claim = {"a"},
                                            .probability = 0.97,
                                            .size = {},
                                            .p_omnibus = {},
                                            .p_targeted = {},
                                            .gain = judging::Gain{.before = 4.0,
                                                                  .after = 1.2,
                                                                  .of_placebo = 2.0,
                                                                  .elpd = 50.0,
                                                                  .elpd_error = 5.0,
                                                                  .coverage = 0.95}}};
  for (auto const* const bar : {"B13", "B14"})
    EXPECT_EQ(counted(bar, good), std::pair(40, true)) << bar;
  auto const spoilt = [&](auto change) {
    auto one = good;
    change(*one.answer.gain);
    return one;
  };
  using judging::Gain;
  EXPECT_FALSE(counted("B13", spoilt([](Gain& g) { g.elpd_error = 20.0; })).second);
  EXPECT_FALSE(counted("B13", spoilt([](Gain& g) { g.after = 1.6; })).second);
  EXPECT_FALSE(counted("B13", spoilt([](Gain& g) { g.coverage = 0.8; })).second);
  EXPECT_FALSE(counted("B14", spoilt([](Gain& g) { g.after = 1.9, g.before = 3.5; })).second);
  EXPECT_FALSE(counted("B14", spoilt([](Gain& g) { g.of_placebo = 1.1; })).second);
  // At the floor either is as good as the other.
  EXPECT_TRUE(counted("B14", spoilt([](Gain& g) { g.after = 0.9, g.of_placebo = 0.8; })).second);
  auto wrong = good;
  wrong.answer.claim = {"b"};
  EXPECT_EQ(counted("B13", wrong).first, 0); // B4's matter
}

TEST(Bars, HoldCleanDataToTheirLevels) {
  judging::JudgedCase clean;
  clean.truth.kind = "clean";
  clean.answer.verdict = "consistent";
  EXPECT_EQ(counted("B2", clean).first, 0); // says nothing of its levels
  clean.answer.p_omnibus = 0.9, clean.answer.p_targeted = 0.6;
  EXPECT_EQ(counted("B2", clean), std::pair(40, true));
  clean.answer.p_targeted = 0.4;
  EXPECT_FALSE(counted("B2", clean).second);
  clean.answer.p_targeted = 0.6, clean.answer.p_omnibus = 0.05;
  EXPECT_FALSE(counted("B2", clean).second);
  EXPECT_TRUE(counted("B15", clean).second);
  clean.answer.gain = judging::Gain{};
  EXPECT_FALSE(counted("B15", clean).second);
}

/// Only groups with the cause in them, and advice that will tell and can be followed.
TEST_F(SmallSet, FollowsAdvice) {
  for (auto const& name : names())
    std::filesystem::copy_file(scratch_ / name / "good.json",
                               scratch_ / name / "diagnosis/diagnosis.json");
  auto const group = [&](char const* name, std::vector<std::string> const& causes,
                         char const* measurement, bool is_enough) {
    auto truth = Json::parse(support::bytes_of(scratch_ / name / "sealed/truth.json"));
    truth["seed"] = 7;
    truth["effects"][0]["size"] = 1.0625;
    std::ofstream(scratch_ / name / "sealed/truth.json") << truth;
    Json const answer = {{"verdict", "undecided"},
                         {"group", causes},
                         {"next_measurement", {{{"name", measurement}, {"enough", is_enough}}}}};
    std::ofstream(scratch_ / name / "diagnosis/diagnosis.json") << answer;
  };
  char const* const balance = "mass of the compact, by balance";
  group("14", {"mass_error", "missing_fines"}, balance, true); // 14 % 4 = 2, a mass error
  group("18", {"mass_error", "missing_fines"}, balance, false);
  group("22", {"mass_error", "missing_fines"}, "radial pressure on the die", true);
  group("26", {"die_size", "missing_fines"}, balance, true);
  auto const advised = judging::advised_cases(scratch_.path());
  ASSERT_EQ(advised.size(), 1u);
  EXPECT_EQ(advised[0].name, "14");
  EXPECT_EQ(advised[0].seed, "7");
  EXPECT_EQ(advised[0].cause, "mass_error");
  EXPECT_EQ(advised[0].size, "1.0625");
  EXPECT_EQ(advised[0].measurement, "compact_mass");
  auto const again = judging::hold_advice(judging::read_cases(scratch_.path()));
  EXPECT_EQ(again.cases, 40);
  EXPECT_EQ(again.count, 12); // the sixteen singles less the four groups
}

TEST_F(SmallSet, PassesAGoodDiagnoser) {
  EXPECT_TRUE(passes("good"));
}

class Broken : public SmallSet, public testing::WithParamInterface<int> {};
TEST_P(Broken, FailsABar) {
  EXPECT_FALSE(passes(broken::names()[static_cast<std::size_t>(GetParam())]));
}
INSTANTIATE_TEST_SUITE_P(All, Broken, testing::Range(0, static_cast<int>(broken::names().size())),
                         [](auto const& at) {
                           return std::string(broken::names()[static_cast<std::size_t>(at.param)]);
                         });

// It reads: with E half as high again the peak is 12 kN higher.
TEST_F(SmallSet, HasAPeakReaderThatReads) {
  hidden::Wish wish{.seed = 1,
                    .kind = hidden::CaseClass::single,
                    .observables = hidden::Observables::A,
                    .causes = {hidden::Effect::young_modulus}};
  wish.relative_size = 2.0;
  write_case(draw_case(wish), scratch_ / "stiff", hidden::Foretold::nothing);
  auto const answer = broken::diagnose("peak", scratch_ / "stiff/data", {});
  ASSERT_EQ(answer["verdict"], "named");
  EXPECT_EQ(answer["causes"][0]["name"], "young_modulus");
}

TEST_F(SmallSet, WithoutAnAnswerIsNoSet) {
  EXPECT_THROW(judging::read_cases(scratch_.path()), std::runtime_error);
}

} // namespace
