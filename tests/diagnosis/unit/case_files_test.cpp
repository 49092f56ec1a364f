#include "tests/diagnosis/hide/case_files.hpp"
#include "tests/diagnosis/hide/detectability.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace {

using namespace hidden;
using support::bytes_of;

Wish wish(std::uint64_t seed, CaseClass kind = CaseClass::single) {
  return {.seed = seed, .kind = kind, .observables = Observables::D};
}

std::string data_of(std::filesystem::path const& folder) {
  std::string all;
  for (auto const* name : {"measured.json", "run1.csv", "run2.csv", "run3.csv"})
    all += bytes_of(folder / "data" / name);
  return all;
}

class HiddenCase : public testing::Test {
protected:
  std::filesystem::path write(Case const& of, std::string const& name) {
    write_case(of, scratch_ / name, Foretold::nothing);
    return scratch_ / name;
  }
  support::ScratchFolder scratch_;
};

TEST_F(HiddenCase, IsItsSeed) {
  auto const a = write(draw_case(wish(4)), "a"), b = write(draw_case(wish(4)), "b");
  auto const c = write(draw_case(wish(5)), "c");
  EXPECT_EQ(data_of(a), data_of(b));
  EXPECT_EQ(bytes_of(a / "sealed/truth.json"), bytes_of(b / "sealed/truth.json"));
  for (auto const* name : {"measured.json", "run1.csv", "run2.csv", "run3.csv"})
    EXPECT_NE(bytes_of(a / "data" / name), bytes_of(c / "data" / name)) << name;
}

TEST_F(HiddenCase, KeepsTheTruthOutOfTheData) {
  auto const hidden_case = draw_case(wish(6));
  auto const data = data_of(write(hidden_case, "a"));
  EXPECT_EQ(data.find(kind_of(hidden_case.hidden[0].effect).name), std::string::npos);
  for (auto const* word : {"truth", "seed", "effect", "class", "lambda", "single"})
    EXPECT_EQ(data.find(word), std::string::npos) << word;
  std::set<std::string> names;
  for (auto const& entry : std::filesystem::directory_iterator(scratch_ / "a/data"))
    names.insert(entry.path().filename());
  EXPECT_EQ(names, (std::set<std::string>{"measured.json", "run1.csv", "run2.csv", "run3.csv"}));
}

// An effect adds to the data of the clean case; nothing else is drawn differently.
TEST_F(HiddenCase, DiffersFromTheCleanOneByItsEffectOnly) {
  auto none = wish(7);
  none.size = 0.0;
  none.causes = {Effect::frame_compliance};
  EXPECT_EQ(data_of(write(draw_case(none), "a")),
            data_of(write(draw_case(wish(7, CaseClass::clean)), "b")));
}

/// What is measured beside a set changes nothing in it.
TEST_F(HiddenCase, IsMeasuredOnceMore) {
  auto more = wish(6);
  more.causes = {Effect::mass_error};
  more.size = 0.02;
  auto const plain = draw_case(more);
  write(plain, "plain");
  auto const data = nlohmann::json::parse(bytes_of(scratch_ / "plain/data/measured.json"));
  auto const again = [&](char const* name) {
    more.extra = extra_named(name);
    auto const folder = write(draw_case(more), name);
    for (auto const* run : {"run1.csv", "run2.csv", "run3.csv"})
      EXPECT_EQ(bytes_of(folder / "data" / run), bytes_of(scratch_ / "plain/data" / run));
    return nlohmann::json::parse(bytes_of(folder / "data/measured.json"));
  };
  auto const number = [&](char const* name) {
    std::vector<double> all;
    auto const found = again(name);
    for (auto const& run : found["runs"])
      if (run["scalars"].contains(name) && run["role"] == "fit")
        all.push_back(run["scalars"][name]["value"]);
    EXPECT_EQ(all.size(), 1u) << name;
    return all.at(0);
  };
  auto const fitted = std::ranges::find(plain.runs, false, &PlannedRun::is_held_out);
  EXPECT_NEAR(number("compact_mass"),
              stated_mass * (1.0 + fitted->repeat.mass) *
                  (1.0 + 0.02 * (1.0 + fitted->repeat.mass_error)),
              25e-6);
  EXPECT_NEAR(number("compact_diameter"), stated_bore, 25e-6);
  EXPECT_NEAR(number("gap_at_peak"), 8e-3, 60e-6); // zeros of 8 um
  EXPECT_NEAR(number("dead_weight"), 10e3, 60.0);
  auto const fast = again("fast");
  ASSERT_EQ(fast["runs"].size(), data["runs"].size() + 1);
  EXPECT_EQ(fast["runs"].back()["role"], "fit");
  EXPECT_EQ(fast["runs"].back()["press"]["speed_down"].get<double>(), 25.0 * mm / 60.0);
  EXPECT_EQ(again("dwell_60")["runs"].back()["press"]["dwell"].get<double>(), 60.0);
  EXPECT_EQ(again("wider")["runs"].back()["press"]["end_gap"].get<double>(), 1.05 * (8.0 * mm));
  EXPECT_THROW((void)extra_named("weight"), std::invalid_argument);
}

TEST_F(HiddenCase, IsOfTheContractsForm) {
  auto const folder = write(draw_case(wish(8)), "a");
  auto const json = nlohmann::json::parse(bytes_of(folder / "data/measured.json"));
  std::set<std::string> keys;
  for (auto const& [key, value] : json.items())
    keys.insert(key);
  EXPECT_EQ(keys, (std::set<std::string>{"sample", "channels", "gap_source", "runs"}));
  EXPECT_EQ(json["gap_source"], "commanded");
  EXPECT_EQ(json["sample"]["mass"]["value"], 9.13e-3);
  EXPECT_EQ(json["sample"]["die_diameter"]["unit"], "m");
  for (auto const& [name, channel] : json["channels"].items())
    EXPECT_GT(channel["sd"].get<double>(), 0.0) << name;
  int held_out = 0;
  for (auto const& run : json["runs"]) {
    held_out += run["role"] == "held-out" ? 1 : 0;
    EXPECT_LT(run["press"]["end_gap"], run["press"]["fill_height"]);
    auto const text = bytes_of(folder / "data" / run["file"].get<std::string>());
    EXPECT_EQ(text.substr(0, text.find('\n')),
              "time [s],punch_gap [m],upper_punch_force [N],lower_punch_force [N],"
              "wall_radial_pressure [Pa]");
  }
  EXPECT_EQ(held_out, 2);
  EXPECT_EQ(json["runs"].size(), 3u);
}

TEST_F(HiddenCase, RefusesWhatContradictsItself) {
  auto clean = wish(1, CaseClass::clean), both = wish(1), unlisted = wish(1), large = wish(1);
  clean.causes = {Effect::breakage};
  EXPECT_THROW(draw_case(clean), std::invalid_argument);
  both.size = 1e-9, both.relative_size = 1.0, both.causes = {Effect::frame_compliance};
  EXPECT_THROW(draw_case(both), std::invalid_argument);
  unlisted.causes = {Effect::stick_slip};
  EXPECT_THROW(draw_case(unlisted), std::invalid_argument);
  large.causes = {Effect::frame_compliance}, large.size = 20.0; // in um/kN
  EXPECT_THROW(draw_case(large), std::invalid_argument);
  write(draw_case(wish(1)), "a");
  EXPECT_THROW(write(draw_case(wish(1)), "a"), std::runtime_error);
}

TEST(HiddenCases, DrawEveryCauseAndBothSigns) {
  std::set<Effect> causes;
  int negative = 0, n = 400;
  for (int seed = 0; seed < n; ++seed) {
    auto const drawn = draw_case(wish(static_cast<std::uint64_t>(seed))).hidden.front();
    causes.insert(drawn.effect);
    negative += drawn.size < 0.0 ? 1 : 0;
    EXPECT_FALSE(kind_of(drawn.effect).is_one_sided && drawn.size <= 0.0);
  }
  EXPECT_EQ(causes.size(), static_cast<std::size_t>(n_known_effects));
  EXPECT_GT(negative, n / 8); // half of the eleven of twenty that have two signs: 0.27 n
}

// The same upper-force signature as E (diagnosis note 4.2, group 1): upper force alone cannot
// separate a gain from E, all gauges can.
TEST(Detector, KnowsThatAGainHidesInE) {
  auto lonely = wish(2);
  lonely.causes = {Effect::force_gain}, lonely.relative_size = 2.0;
  auto full = lonely;
  lonely.observables = Observables::A;
  auto const with_one = draw_case(lonely), with_all = draw_case(full);
  double const one = Detector(with_one).lambda(with_one.hidden);
  EXPECT_GT(Detector(with_all).lambda(with_all.hidden), 3.0 * one) << one;
}

// The largest sizes that can be drawn still make a cycle.
TEST(HiddenCases, SurviveTheirExtremes) {
  for (int k = 0; k < n_effects; ++k)
    for (auto const limit : {least_size, largest_size}) {
      auto const effect = static_cast<Effect>(k);
      auto const cycle = press_cycle({}, Effects{}.with(effect, limit(effect)), {}, {});
      for (auto const& at : cycle.moments)
        ASSERT_TRUE(std::isfinite(at.upper + at.lower + at.radial)) << kind_of(effect).name;
    }
}

TEST(Detector, FindsTheSizeOfALambda) {
  auto asked = wish(2);
  asked.causes = {Effect::wall_friction};
  auto hidden_case = draw_case(asked);
  Detector const detector(hidden_case);
  auto effect = hidden_case.hidden.front();
  effect.size = detector.size_for(effect, 16.0);
  EXPECT_NEAR(detector.lambda({effect}), 16.0, 0.6);
}

} // namespace
