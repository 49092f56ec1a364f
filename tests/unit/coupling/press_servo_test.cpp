#include "coupling/press_programme.hpp"
#include "tests/unit/coupling/press_stand_in.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace coupling;
using namespace stand_in;

namespace {

// 185 grains of 3 mm and 3500 kg/m^3 weigh 9.154 g; with 1e6 N/m  tau = 4 sqrt(m/k) = 0.383 ms.
constexpr double tau = 0.383e-3;

struct Held {
  double largest = 0.0; // [N], over the hold
  double final = 0.0;   // [N]
};

/// Presses to 500 N, then asks the servo for `force`; the bed creeps at `creep_speed` [m/s].
Held hold(double force, double duration, double creep_speed = 0.0) {
  auto world = press_world();
  auto cycle = programme({press_to_force(500.0), keep_force(force, duration)});
  run_stage(world, cycle);
  Bed bed;
  Held held;
  cycle.start_stage(world);
  while (!cycle.stage_has_ended(world)) {
    bed.creep += creep_speed * cycle.present_step();
    one_step(world, cycle, bed);
    held.final = squeezing_force(tool_named(world, "upper_punch"));
    held.largest = std::max(held.largest, held.final);
  }
  return held;
}

} // namespace

TEST(ForceServo, ReachesTheForceAndOvershootsAsACriticallyDampedLoop) {
  auto const held = hold(600.0, 30.0 * tau);
  EXPECT_NEAR(held.final, 600.0, 0.01);
  // e'' + e'/tau + e/(4 tau^2) = 0 with e(0) = 100 N, e'(0) = -e(0)/tau:  e = 100 (1 - t/(2 tau))
  // exp(-t/(2 tau)), lowest at t = 4 tau: -100 exp(-2) = -13.5 N. The speed limit of 0.2 m/s, below
  // 100 N/(k tau) = 0.26 m/s, and its standing integral make it a little less.
  EXPECT_GT(held.largest, 600.0 + 9.0);
  EXPECT_LT(held.largest, 600.0 + 13.6);
}

TEST(ForceServo, ACreepingBedLeavesNoOffset) {
  // Without the integral the offset would be k tau v = 1e6 N/m x 0.383 ms x 0.01 m/s = 3.8 N.
  auto const held = hold(500.0, 60.0 * tau, 0.01);
  EXPECT_NEAR(held.final, 500.0, 0.02);
}

TEST(ForceServo, ReleasesToASmallerForce) {
  EXPECT_NEAR(hold(300.0, 30.0 * tau).final, 300.0, 0.05);
}

TEST(ForceServo, MeasuresTheBedsSecantWhileItIsPressed) {
  ForceServo servo;
  Bed const bed;
  for (int k = 0; k <= 1000; ++k) {
    double const gap = 12e-3 - 4e-6 * k;
    servo.watch(gap, bed.force(gap));
  }
  EXPECT_NEAR(servo.stiffness(), stiffness, 1e-6 * stiffness);
  servo.start(1.0);
  EXPECT_NEAR(servo.stiffness(), stiffness,
              1e-6 * stiffness); // what was seen goes before the estimate
}

TEST(ForceServo, StartsFromTheEstimateWhereNothingWasPressed) {
  ForceServo servo;
  servo.start(2e6);
  EXPECT_EQ(servo.stiffness(), 2e6);
}

TEST(ForceServo, KeepsItsSpeedLimit) {
  ForceServo servo;
  servo.start(stiffness);
  ServoReading const now{.gap = 9e-3, .force = 0.0, .mass = 9e-3};
  EXPECT_EQ(servo.closing_speed(now, 1e6, 0.2, 1e-7), 0.2);
  EXPECT_EQ(servo.closing_speed({.gap = 9e-3, .force = 1e6, .mass = 9e-3}, 0.0, 0.2, 1e-7), -0.2);
}
