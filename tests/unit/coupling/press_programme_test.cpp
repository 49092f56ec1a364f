#include "coupling/gap_path.hpp"
#include "coupling/press_programme.hpp"
#include "dem/expect.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/coupling/press_stand_in.hpp"

#include <gtest/gtest.h>

using namespace coupling;
using namespace stand_in;

namespace {

Stage timed(std::string name, StageKind kind, double duration, double speed = 0.0) {
  return {.name = std::move(name),
          .kind = kind,
          .tools = {"upper_punch"},
          .speed = speed,
          .until = Limit::time,
          .duration = duration};
}

std::string guard_message(auto&& action) {
  try {
    action();
  } catch (dem::PhysicsGuard const& guard) {
    return guard.what();
  }
  return "no guard tripped";
}

} // namespace

TEST(PressProgramme, StepsDivideAStageEquallyAndLandOnItsEnd) {
  auto world = press_world();
  auto cycle = programme({timed("loading", StageKind::move, 1e-3, -0.2)});
  cycle.start_stage(world);
  // ceil(1e-3 / 3e-7) = 3334 steps.
  EXPECT_DOUBLE_EQ(cycle.present_step(), 1e-3 / 3334.0);
  while (!cycle.stage_has_ended(world))
    one_step(world, cycle);
  EXPECT_EQ(world.step, 3334u);
  EXPECT_EQ(world.time, 1e-3); // to the bit, whatever the sum of the steps rounds to
  EXPECT_NEAR(punch_gap(world, cycle.faces()), fill_height - 0.2e-3, 1e-15);
}

TEST(PressProgramme, AWholeNumberOfLongestStepsIsNotSplitFurther) {
  auto world = press_world();
  auto cycle = programme({timed("free", StageKind::free, 1000.0 * longest_step)});
  cycle.start_stage(world);
  while (!cycle.stage_has_ended(world))
    one_step(world, cycle);
  EXPECT_EQ(world.step, 1000u);
}

TEST(PressProgramme, FollowsAMeasuredGap) {
  support::ScratchFolder const scratch;
  auto const file = scratch / "measured.csv";
  // Milliseconds and millimetres, a second row without gap, a dwell; the clock does not start at 0.
  support::put_bytes(file, "time [ms],punch_gap [mm],upper_punch_force [N]\n"
                           "100,20,0\n101,nan,0\n102,19.5,1\n104,19.2,2\n106,19.2,2\n108,19.9,0\n");
  GapPath const path = read_gap_path(file, 0.5);
  EXPECT_EQ(path.time.size(), 5u);
  EXPECT_NEAR(path.time.back(), 4e-3, 1e-15);
  EXPECT_NEAR(gap_at(path, 1.5e-3), 19.35e-3, 1e-15);
  EXPECT_EQ(gap_at(path, 9.0), path.gap.back());
  for (std::string const punch : {"upper_punch", "lower_punch"}) {
    auto world = press_world();
    auto cycle = programme({{.name = "measured",
                             .kind = StageKind::follow,
                             .tools = {punch},
                             .duration = path.time.back(),
                             .path = path}});
    cycle.start_stage(world);
    while (!cycle.stage_has_ended(world)) {
      one_step(world, cycle);
      EXPECT_NEAR(punch_gap(world, cycle.faces()), gap_at(path, world.time), 1e-15);
    }
    EXPECT_EQ(world.time, path.time.back());
    // A restart brings the path with it, whatever its file has become.
    Memory memory;
    cycle.visit_state(memory.writer());
    EXPECT_EQ(std::any_cast<std::vector<double>>(memory.fields.at("programme/path_0_gap")),
              path.gap);
  }
}

TEST(PressProgramme, RefusesPathsThatAreNone) {
  support::ScratchFolder const scratch;
  auto const file = scratch / "measured.csv";
  auto const refusal = [&](std::string const& text) {
    support::put_bytes(file, text);
    try {
      read_gap_path(file, 1.0);
    } catch (dem::InvalidInput const& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_NE(refusal("time [s],gap [m]\n0,0.02\n1,0.01\n").find("no column 'punch_gap'"),
            std::string::npos);
  EXPECT_NE(refusal("time [s],punch_gap [m]\n0,0.02\n").find("fewer than two rows"),
            std::string::npos);
  EXPECT_NE(refusal("time [s],punch_gap [m]\n0,0.02\n1,0.01\n1,0.01\n").find("row 3: time"),
            std::string::npos);
  EXPECT_NE(refusal("time [s],punch_gap [m]\n0,0.02\n1,-0.01\n").find("row 2: punch_gap"),
            std::string::npos);
}

TEST(PressProgramme, StopsAtTheGap) {
  auto world = press_world();
  auto cycle = programme({press_to_gap(8e-3)});
  run_stage(world, cycle);
  EXPECT_NEAR(punch_gap(world, cycle.faces()), 8e-3, 1e-12);
  EXPECT_NEAR(world.time, 0.06, 1e-15); // 12 mm at 0.2 m/s
  EXPECT_TRUE(cycle.is_done());
}

TEST(PressProgramme, TheLowerPunchClosesTheGapFromBelow) {
  auto world = press_world();
  Stage stage = press_to_gap(15e-3);
  stage.tools = {"lower_punch"};
  stage.speed = 0.2;
  auto cycle = programme({stage});
  run_stage(world, cycle);
  EXPECT_NEAR(tool_named(world, "lower_punch").displacement.z(), 5e-3, 1e-12);
  EXPECT_EQ(tool_named(world, "upper_punch").displacement.z(), 0.0);
}

TEST(PressProgramme, StopsAtTheFirstStepThatCarriesTheForce) {
  auto world = press_world();
  auto cycle = programme({press_to_force(500.0)});
  run_stage(world, cycle);
  double const force = squeezing_force(tool_named(world, "upper_punch"));
  // A step closes 0.2 m/s x 3e-7 s = 60 nm and adds 0.06 N.
  EXPECT_GE(force, 500.0);
  EXPECT_LT(force, 500.0 + 1.01 * stiffness * 0.2 * longest_step);
}

TEST(PressProgramme, AnOpeningMotionStopsWhenTheForceHasGone) {
  auto world = press_world();
  Stage unload = press_to_force(0.0);
  unload.name = "unloading";
  unload.speed = 0.2;
  auto cycle = programme({press_to_gap(8e-3), unload});
  run_stage(world, cycle);
  EXPECT_NEAR(squeezing_force(tool_named(world, "upper_punch")), 2000.0, 1e-3); // 1e6 N/m x 2 mm
  run_stage(world, cycle);
  EXPECT_NEAR(punch_gap(world, cycle.faces()), bed_height, 1.01 * 0.2 * longest_step);
}

TEST(PressProgramme, AForceThatIsNotReachedInTimeStopsTheRun) {
  auto world = press_world();
  Stage stage = press_to_force(500.0);
  stage.duration = 0.051; // the bed carries 200 N then: 0.2 mm of compression
  auto cycle = programme({stage});
  auto const message = guard_message([&] { run_stage(world, cycle); });
  EXPECT_NE(message.find("stage 'loading': upper_punch carries 200 N after 0.051 s"),
            std::string::npos)
      << message;
}

TEST(PressProgramme, PunchesThatMeetStopTheRun) {
  auto world = press_world();
  auto cycle = programme({press_to_force(1e5)}); // the bed's spring ends at 10 kN
  auto const message = guard_message([&] { run_stage(world, cycle); });
  EXPECT_NE(message.find("the punches meet"), std::string::npos) << message;
  EXPECT_NEAR(world.time, 0.1, 1e-6);
}

TEST(PressProgramme, AGapThatTakesTooLongStopsTheRun) {
  auto world = press_world();
  Stage stage = press_to_gap(8e-3);
  stage.duration = 0.059;
  auto cycle = programme({stage});
  auto const message = guard_message([&] { cycle.start_stage(world); });
  EXPECT_NE(message.find("a gap of 0.008 m is not reached"), std::string::npos) << message;
}

TEST(PressProgramme, ReleasedToolsVanishAtOnce) {
  auto world = press_world();
  Stage const release{
      .name = "release", .kind = StageKind::release, .tools = {"die", "upper_punch"}};
  auto cycle = programme({press_to_gap(8e-3), release});
  run_stage(world, cycle);
  auto const steps = world.step;
  run_stage(world, cycle);
  EXPECT_EQ(world.step, steps);
  EXPECT_FALSE(tool_named(world, "die").present);
  EXPECT_FALSE(tool_named(world, "upper_punch").present);
  EXPECT_TRUE(tool_named(world, "lower_punch").present);
  EXPECT_EQ(squeezing_force(tool_named(world, "upper_punch")), 0.0);
}

TEST(PressProgramme, NothingMovesWhileHeldOrFree) {
  auto world = press_world();
  auto cycle = programme({press_to_gap(8e-3), timed("dwell", StageKind::hold, 1e-4),
                          timed("rest", StageKind::free, 1e-4)});
  run_stage(world, cycle);
  double const gap = punch_gap(world, cycle.faces());
  run_stage(world, cycle);
  run_stage(world, cycle);
  EXPECT_EQ(punch_gap(world, cycle.faces()), gap);
}

TEST(PressProgramme, AnAdaptiveStepFollowsTheStateAndStillLandsOnTheEnd) {
  auto world = press_world();
  // The longest step halves once 0.5 ms have passed.
  PressProgramme cycle(
      {timed("loading", StageKind::move, 1e-3, -0.2)}, {.lower = 0.0, .upper = fill_height},
      [](dem::World const& w) { return w.time < 0.5e-3 ? longest_step : 0.5 * longest_step; },
      true);
  run_stage(world, cycle);
  EXPECT_EQ(world.time, 1e-3);
  // 0.5e-3 / 3e-7 = 1667 and 0.5e-3 / 1.5e-7 = 3333 steps; a plan may run on for `renewal` long
  // ones.
  EXPECT_GE(world.step, 5000u - PressProgramme::renewal);
  EXPECT_LE(world.step, 5000u + PressProgramme::renewal);
}

TEST(PressProgramme, GoesOnFromASavedStateToTheSameBits) {
  std::vector<Stage> const stages{press_to_force(500.0), keep_force(600.0, 2e-3)};
  auto world = press_world();
  auto cycle = programme(stages);
  run_stage(world, cycle);
  cycle.start_stage(world);
  for (int k = 0; k < 1000; ++k)
    one_step(world, cycle);
  auto restored_world = world;
  auto restored = programme(stages);
  Memory memory;
  cycle.visit_state(memory.writer());
  restored.visit_state(memory.reader());
  while (!cycle.stage_has_ended(world))
    one_step(world, cycle);
  while (!restored.stage_has_ended(restored_world))
    one_step(restored_world, restored);
  EXPECT_EQ(world.time, restored_world.time);
  EXPECT_EQ(world.step, restored_world.step);
  EXPECT_EQ(tool_named(world, "upper_punch").displacement.z(),
            tool_named(restored_world, "upper_punch").displacement.z());
}

TEST(PressProgramme, TellsHowFarItIs) {
  auto world = press_world();
  // 0.06 s to the gap, 0.04 s free.
  auto cycle = programme({press_to_gap(8e-3), timed("rest", StageKind::free, 0.04)});
  EXPECT_EQ(cycle.run_progress(world), 0.0);
  run_stage(world, cycle);
  EXPECT_NEAR(cycle.run_progress(world), 0.6, 1e-12);
  run_stage(world, cycle);
  EXPECT_EQ(cycle.run_progress(world), 1.0);
}
