#include "coupling/reduced/press_chain.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace coupling::reduced;

namespace {

PressedBed pressed() {
  return {.law = {.stiffness = 400e6,
                  .cohesion = 15e6,
                  .onset = 0.6,
                  .exponent = 1.6,
                  .recovery = 0.7,
                  .wall_friction = 0.2,
                  .radial_ratio = 0.45},
          .bed = {.solid_area = 7e-3, .bore = 22e-3}};
}
double const height = 8.4e-3;

} // namespace

TEST(PressedBed, IsTheBedWhereNothingGivesWay) {
  auto const found = forces(pressed(), 8.2e-3, 8e-3);
  auto const plain = bed_forces(pressed().law, pressed().bed, 8.2e-3, 8e-3);
  EXPECT_EQ(found.upper, plain.upper);
  EXPECT_EQ(found.lower, plain.lower);
  EXPECT_EQ(found.radial_pressure, plain.radial_pressure);
}

/// The mean over a disc of strips at the heights h + tilt/2 x, x from -1 to 1.
TEST(PressedBed, ATiltIsTheMeanOverTheFace) {
  auto bed = pressed();
  bed.tilt = 0.6e-3;
  double sum = 0.0, weight = 0.0;
  constexpr int n = 4000;
  for (int k = 0; k < n; ++k) {
    double const x = -1.0 + 2.0 * (k + 0.5) / n, w = std::sqrt(1.0 - x * x);
    double const own = height + 0.5 * bed.tilt * x;
    sum += w * bed_forces(bed.law, bed.bed, own, own).upper;
    weight += w;
  }
  double const level = forces(pressed(), height, height).upper;
  EXPECT_GT(sum / weight - level, 1e-3 * level); // the force bends upwards
  EXPECT_NEAR(forces(bed, height, height).upper, sum / weight, 1e-6 * level);
}

/// The height at which a stiff die has the solid fraction of one that is D_0 + a p wide.
double narrow(double height, double radial_pressure) {
  return height * std::pow(1.0 + 1e-11 * radial_pressure / 22e-3, 2);
}

/// D = D_0 + a p(D), solved here by many rounds: a bed in a stiff die at the height with the same
/// solid fraction, under the same faces.
TEST(PressedBed, ADieThatGivesIsWiderByItsPressure) {
  auto bed = pressed();
  bed.die_yield = 1e-11;
  bed.law.wall_friction = 0.0; // its share goes with the height itself
  double own = height;
  for (int round = 0; round < 50; ++round)
    own = narrow(height, bed_forces(bed.law, bed.bed, own, own).radial_pressure);
  auto const found = bed_forces(bed.law, bed.bed, own, own);
  auto stiff = bed;
  stiff.die_yield = 0.0;
  double const peak = forces(stiff, height, height).upper;
  EXPECT_LT(found.upper, 0.99 * peak);
  EXPECT_NEAR(forces(bed, height, height).upper, found.upper, 1e-4 * peak);
  EXPECT_NEAR(narrow_height(bed, height), own, 1e-7);
  // Opening: it closes again, from the solid fraction that it came to.
  double const above = height + 2e-5;
  double now = above;
  for (int round = 0; round < 50; ++round)
    now = narrow(above, bed_forces(bed.law, bed.bed, now, own).radial_pressure);
  auto const opened = bed_forces(bed.law, bed.bed, now, own);
  EXPECT_NEAR(forces(bed, above, height).upper, opened.upper, 1e-4 * peak);
  double const kept = opened.upper / found.upper;
  EXPECT_GT(kept, 1.0005 * forces(stiff, above, height).upper / peak);
}

TEST(RateLaw, GoesWithTheLogarithmOfTheRate) {
  RateLaw const law{.gain = 0.02, .reference = 1e-4, .memory = 4e-3, .turning = 1e-4};
  PressMoment const slow{.closing_speed = 2e-5}, quick{.closing_speed = 4e-4};
  auto const factor = [](double rate) { return 1.0 + 0.02 * std::log(1.0 + rate / 1e-4); };
  EXPECT_DOUBLE_EQ(rate_factor(law, slow, 8e-3), factor(2e-5 / 8e-3));
  EXPECT_DOUBLE_EQ(rate_factor(law, quick, 8e-3), factor(4e-4 / 8e-3));
  EXPECT_EQ(rate_factor({}, quick, 8e-3), 1.0);
}

TEST(RateLaw, RelaxesInADwellAndTurnsRoundAsItOpens) {
  RateLaw const law{.gain = 0.02, .reference = 1e-4, .memory = 4e-3, .turning = 1e-4};
  double const rate = 4e-4 / 8e-3;
  double const left = 1.0 / (1.0 / rate + 30.0 / 4e-3);
  EXPECT_DOUBLE_EQ(rate_factor(law, {.closing_speed = 4e-4, .dwelt = 30.0}, 8e-3),
                   1.0 + 0.02 * std::log1p(left / 1e-4));
  PressMoment const far{.closing_speed = 4e-4, .opening_speed = 4e-4, .opened = 5e-3};
  EXPECT_NEAR(rate_factor(law, far, 8e-3), 1.0 - 0.02 * std::log1p(rate / 1e-4), 1e-12);
  PressMoment half = far;
  half.opened = 1e-4 * std::log(2.0);
  EXPECT_NEAR(rate_factor(law, half, 8e-3), 1.0, 1e-12);
}

TEST(PressMachine, ThermalDriftDiesOut) {
  GapCourse const course = press_course(20e-3, 8e-3, 1e-3, 1e-3);
  Machine const machine{.frame = {.thermal_drift = 1e-5}, .drift_decay = 0.1};
  for (auto const& r : press_cycle(pressed(), machine, course, {1.0, 6.0, 12.0}))
    EXPECT_NEAR(r.height - r.commanded_gap, 1e-5 * (1.0 - std::exp(-0.1 * r.time)) / 0.1, 1e-15);
}

TEST(PressMachine, AnOffsetHasItsPitchFromTheTurnOn) {
  GapCourse const course = press_course(20e-3, 8e-3, 1e-3, 1e-3);
  Machine const machine{.frame = {.gap_offset = 1e-4}, .gap_pitch = 20.0};
  for (auto const& r : press_cycle(pressed(), machine, course, {1.0, 6.0, 12.0}))
    EXPECT_NEAR(r.height - r.commanded_gap, 1e-4 * (1.0 + 20.0 * (r.commanded_gap - 8e-3)), 1e-15);
}

TEST(PressMachine, AGapAtTheFacesKnowsNoFrame) {
  GapCourse const course = press_course(20e-3, 8e-3, 1e-3, 1e-3);
  Machine machine{.frame = {.stiffness = 30e6}};
  EXPECT_GT(press_cycle(pressed(), machine, course, {12.0}).front().height, 8.2e-3);
  machine.gap_is_of_faces = true;
  EXPECT_EQ(press_cycle(pressed(), machine, course, {12.0}).front().height, 8e-3);
}

/// On a ramp each stage is late by its own time constant: together by the whole lag.
TEST(PressMachine, ASecondStageSharesTheLag) {
  GapCourse const course = press_course(20e-3, 8e-3, 1e-3, 1e-3);
  std::vector<double> samples;
  for (double t = 0.0; t < 12.0; t += 0.005)
    samples.push_back(t);
  auto const shown = [&](double second) {
    Machine const machine{.load_cell = {.lag = 0.1}, .second_stage = second};
    return press_cycle(pressed(), machine, course, samples);
  };
  auto const prompt = press_cycle(pressed(), {}, course, samples);
  for (double const second : {0.0, 0.5}) {
    double const now = shown(second).back().load_cell;
    auto const before = prompt[prompt.size() - 1 - 20].load_cell; // 0.1 s
    EXPECT_NEAR(now, before, 0.01 * before);
  }
  // At a corner two stages are softer than one.
  auto const after = [&](double second) {
    Machine const machine{.load_cell = {.lag = 0.1}, .second_stage = second};
    return press_cycle(pressed(), machine, course, {12.0, 12.02})[1].load_cell;
  };
  EXPECT_NE(after(0.0), after(0.5));
}
