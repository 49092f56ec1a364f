#include "tests/diagnosis/grains/grain_causes.hpp"
#include "tests/diagnosis/grains/laboratory.hpp"
#include "tests/diagnosis/grains/peer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace hidden {
namespace {

/// 1000 N per millimetre below 10 mm, down to 8 mm and up again; the lower punch has 0.9 of it.
Curve straight_curve(int n) {
  Curve curve;
  for (int k = 0; k <= n; ++k) {
    double const height = (12.0 - 4.0 * k / n) * mm;
    double const force = std::max(0.0, 1e6 * (10 * mm - height));
    curve.loading.push_back({height, force, 0.9 * force, 2000.0 * force});
  }
  curve.unloading.assign(curve.loading.rbegin(), curve.loading.rend());
  return curve;
}

/// The last moment before the machine turns.
Moment turn_of(std::vector<Moment> const& moments) {
  return *std::ranges::min_element(moments, {}, &Moment::gap);
}

TEST(Laboratory, APerfectMachineShowsWhatTheGrainsBear) {
  auto const moments = seen_by_machine(straight_curve(100), {}, {});
  EXPECT_DOUBLE_EQ(turn_of(moments).gap, 8 * mm);
  EXPECT_DOUBLE_EQ(turn_of(moments).upper, 2000.0);
  EXPECT_NEAR(turn_of(moments).time, 4 * mm / laboratory_speed, 1e-9);
  EXPECT_NEAR(moments.back().time, 8 * mm / laboratory_speed, 1e-9);
}

TEST(Laboratory, AFrameThatGivesIsCommandedFurther) {
  double const compliance = 1e-7;
  auto const at = turn_of(seen_by_machine(
      straight_curve(100), Effects().with(Effect::frame_compliance, compliance), {}));
  // F = 2000 N, F_s = 200 N.
  EXPECT_NEAR(at.gap, 8 * mm - compliance * (2000.0 + 0.25 * 200.0 * 2000.0 / 2200.0), 1e-12);
  EXPECT_DOUBLE_EQ(at.height, 8 * mm);
}

TEST(Laboratory, OffsetAndDriftOfTheGapAdd) {
  auto const with = Effects().with(Effect::gap_offset, 1e-4).with(Effect::thermal_drift, 1e-7);
  auto const at = turn_of(seen_by_machine(straight_curve(100), with, {.zero = 1e-5}));
  double const drift = 1e-7 * 1800.0 * -std::expm1(-at.time / 1800.0);
  EXPECT_NEAR(at.gap, 8 * mm - 1e-5 - 1e-4 * (1.0 + 0.1 * (at.gap - 8 * mm) / (12 * mm)) - drift,
              1e-10);
}

TEST(Laboratory, TheLoadCellHasGainAndOffset) {
  auto const with = Effects().with(Effect::force_gain, 0.1).with(Effect::force_offset, -20.0);
  auto const at = turn_of(seen_by_machine(straight_curve(100), with, {.cell_zero = 0.5}));
  EXPECT_NEAR(at.upper,
              2000.0 * (1.0 + 0.1 * 1.05) - 20.0 * (1.0 + 0.1 * std::exp(-at.time / 200.0)) + 0.5,
              1e-9);
  EXPECT_DOUBLE_EQ(at.lower, 1800.0);
}

TEST(Laboratory, ALaggingCellShowsARampLate) {
  double const lag = 2.0;
  auto const moments =
      seen_by_machine(straight_curve(400), Effects().with(Effect::force_lag, lag), {});
  // On a ramp both stages have settled: late by the lag in all.
  EXPECT_NEAR(turn_of(moments).upper, 2000.0 - lag * 1e6 * laboratory_speed, 1e-3);
}

TEST(Laboratory, ReadingsAreTheSeedsAndScatterAsStated) {
  auto const moments = seen_by_machine(straight_curve(100), {}, {});
  auto const rows = read_moments(moments, 9 * mm, {}, 5),
             again = read_moments(moments, 9 * mm, {}, 5);
  EXPECT_EQ(rows.upper, again.upper);
  EXPECT_NE(rows.upper, read_moments(moments, 9 * mm, {}, 6).upper);
  double sum = 0.0;
  int n = 0;
  for (std::size_t k = 0; k < rows.time.size(); ++k)
    if (rows.gap[k] > 10.1 * mm)
      sum += rows.upper[k] * rows.upper[k], ++n;
  ASSERT_GT(n, 300); // the standard error of a variance is below 8 %
  EXPECT_NEAR(sum / n, 1.0, 0.4);
}

TEST(Curve, MeanIsTakenAtEqualHeights) {
  auto const mean = mean_of({straight_curve(40), straight_curve(100)});
  for (auto const& at : mean.loading)
    EXPECT_NEAR(at.upper, std::max(0.0, 1e6 * (10 * mm - at.height)), 1e-6);
  EXPECT_EQ(mean.loading.size(), 41u);
}

TEST(Curve, ARunWithoutAColumnIsRefused) {
  auto const folder = std::filesystem::path(testing::TempDir()) / "grains_no_column";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "curves.csv") << "time [s],stage\n0,loading\n";
  try {
    read_run(folder);
    FAIL() << "is not refused";
  } catch (std::runtime_error const& error) {
    EXPECT_NE(std::string(error.what()).find("compact_height [m]"), std::string::npos)
        << error.what();
  }
}

TEST(GrainCauses, EachInTheGrainsChangesTheCase) {
  for (auto const& cause : grain_causes())
    if (cause.place == Place::grains) {
      EXPECT_NE(entries_of(with_cause({}, cause.effect, cause.trial)), entries_of({}))
          << kind_of(cause.effect).name;
    } else {
      EXPECT_THROW(with_cause({}, cause.effect, 0.1), std::invalid_argument);
    }
}

TEST(Peer, FillsInAllGrainsAndRefusesWhatItLacks) {
  auto const deck = deck_of({.packing = 7, .friction = 0.31}).front().second;
  EXPECT_NE(deck.find("particles_in_region 2204"), std::string::npos);
  EXPECT_NE(deck.find("peratomtypepair 3 0.31 0.31 0.2"), std::string::npos);
  EXPECT_THROW(deck_of({.more = {"Contact/Multi-contact coefficient=0.3"}}), std::invalid_argument);
}

} // namespace
} // namespace hidden
