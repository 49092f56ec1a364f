#include "coupling/press_guards.hpp"

#include "dem/expect.hpp"
#include "tests/regression/tiny_press.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace coupling;

namespace {

std::string verdict(Press const& press, Reading const& reading) {
  try {
    guard(press, reading);
  } catch (dem::PhysicsGuard const& tripped) {
    return tripped.what();
  }
  return "passed";
}

void expect_trips(Press const& press, Reading const& reading, std::string const& evidence) {
  auto const message = verdict(press, reading);
  EXPECT_NE(message.find(evidence), std::string::npos) << message;
  EXPECT_NE(message.find("stage 'loading', t = 0 s, step 0"), std::string::npos) << message;
}

} // namespace

TEST(PressGuards, PassASoundReading) {
  auto const press = tiny::press();
  EXPECT_EQ(verdict(press, read_press(press)), "passed");
}

TEST(PressGuards, NoValueThatIsNotFiniteReachesARecord) {
  auto const press = tiny::press();
  Reading reading = read_press(press);
  reading.mean_overlap = std::numeric_limits<double>::quiet_NaN();
  expect_trips(press, reading, "mean_overlap is not finite");
  reading = read_press(press);
  reading.upper_punch_force = std::numeric_limits<double>::infinity();
  expect_trips(press, reading, "upper_punch_force is not finite");
}

TEST(PressGuards, OverlapsEndWhereTheLawDoes) {
  auto const press = tiny::press({"Time stepping/Largest relative overlap=0.5"});
  Reading reading = read_press(press);
  reading.max_relative_overlap = 0.499;
  EXPECT_EQ(verdict(press, reading), "passed");
  reading.max_relative_overlap = 0.501;
  expect_trips(press, reading,
               "an overlap of 0.501 of the smaller radius exceeds the limit of 0.5");
}

TEST(PressGuards, EnergyThatNobodyPutInStopsTheRun) {
  auto press = tiny::press({"Time stepping/Largest energy error=0.1"});
  press.tally.peak_work = 1e-2;
  Reading reading = read_press(press);
  reading.energy_error = 0.99e-3;
  EXPECT_EQ(verdict(press, reading), "passed");
  reading.energy_error = 1.01e-3;
  expect_trips(press, reading, "J are not accounted for");
  reading.energy_error = -1.01e-3; // energy that vanishes is as wrong
  expect_trips(press, reading, "J are not accounted for");
}

TEST(PressGuards, GrainsThatWentThroughAToolAreCounted) {
  auto press = tiny::press();
  EXPECT_EQ(read_press(press).grains_outside, 0.0);
  auto& grains = press.world.grains;
  // Behind the die, below the lower punch, above the upper one; each wholly. A fourth only leans
  // out.
  grains.position[0] = {3e-3 + 1.01 * grains.radius[0], 0.0, 4e-3};
  grains.position[1] = {0.0, 0.0, -1.01 * grains.radius[1]};
  grains.position[2] = {0.0, 0.0, 8e-3 + 1.01 * grains.radius[2]};
  grains.position[3] = {0.0, 0.0, -0.99 * grains.radius[3]};
  auto const reading = read_press(press);
  EXPECT_EQ(reading.grains_outside, 3.0);
  Reading only_outside;
  only_outside.grains_outside = 3.0;
  expect_trips(press, only_outside, "3 grains went through the tools");
  tool_named(press.world, "die").present = false;
  EXPECT_EQ(read_press(press).grains_outside, 0.0); // on an open punch grains may roll off
}

TEST(PressGuards, AToolForceThatIsNoNumberIsSeenInItsStep) {
  auto press = tiny::press();
  EXPECT_NO_THROW(guard_step(press.world));
  tool_named(press.world, "die").force.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(guard_step(press.world), dem::PhysicsGuard);
}

TEST(PressGuards, TheStepIsMeasuredAgainstTheHertzCollision) {
  auto press = tiny::press();
  EXPECT_EQ(step_to_collision_time(press, 1e-6), 0.0); // nothing moves, nothing collides
  press.world.grains.velocity[0] = {0.0, 0.5, 0.0};
  // v = 2 x 0.5 m/s. Shortest for the lightest grain: 1 mm, 3000 kg/m^3: m = 1.5708e-6 kg, R/2 =
  // 0.25 mm, E* = 25 MPa / (2 (1 - 0.0625)) = 13.333 MPa: t = 2.87 (m^2 / (R/2 E*^2 v))^0.2 = 2.87
  // (2.4674e-12 / 4.4444e10)^0.2 = 2.87 x 3.5459e-5 = 1.0177e-4 s... per 1e-6 s
  double const m = 3000.0 * dem::pi / 6.0 * 1e-9;
  double const E = 25e6 / (2.0 * (1.0 - 0.25 * 0.25));
  double const collision = 2.87 * std::pow(m * m / (0.25e-3 * E * E * 1.0), 0.2);
  EXPECT_NEAR(collision, 1.02e-4, 0.02e-4);
  EXPECT_NEAR(step_to_collision_time(press, 1e-6), 1e-6 / collision, 1e-12);
  tool_named(press.world, "upper_punch").velocity.z() = -0.8; // v = max(2 x 0.5, 0.5 + 0.8)
  EXPECT_NEAR(step_to_collision_time(press, 1e-6), 1e-6 / collision * std::pow(1.3, 0.2), 1e-12);
}
