#include "coupling/case_file.hpp"
#include "coupling/press_frame.hpp"
#include "dem/expect.hpp"
#include "tests/unit/coupling/press_stand_in.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace coupling;
using namespace stand_in;

namespace {

/// The gap at which bed and frame carry the same force while the machine commands `commanded`:
/// bisection of  g = commanded + D(F(g)).
double balanced_gap(Bed const& bed, FrameLaw const& law, double commanded) {
  double low = commanded, high = bed_height;
  for (int k = 0; k < 200; ++k) {
    double const middle = 0.5 * (low + high);
    (commanded + law.deflection(bed.force(middle)) > middle ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

Stage rest(double duration) {
  return {.name = "rest",
          .kind = StageKind::hold,
          .tools = {"upper_punch"},
          .until = Limit::time,
          .duration = duration};
}

PressProgramme on_frame(std::vector<Stage> stages, FrameLaw law) {
  return {std::move(stages),
          {.lower = 0.0, .upper = fill_height},
          [](dem::World const&) { return longest_step; },
          false,
          law};
}

} // namespace

TEST(FrameLaw, GivesDeflectionComplianceAndEnergyOfItsFormula) {
  FrameLaw const law{.stiffness = 1e8, .seating = 20e-6, .seating_force = 500.0};
  // D(1000 N) = 10 um + 20 um (1 - exp(-2)).
  EXPECT_NEAR(law.deflection(1000.0), 10e-6 + 20e-6 * (1.0 - std::exp(-2.0)), 1e-18);
  EXPECT_NEAR(law.compliance(1000.0), (law.deflection(1000.1) - law.deflection(999.9)) / 0.2,
              1e-14);
  double work = 0.0; // midpoint rule: error h^2/12 F_s^-2, some 1e-9
  for (int k = 0; k < 10000; ++k)
    work += (0.1 * k + 0.05) * (law.deflection(0.1 * (k + 1)) - law.deflection(0.1 * k));
  EXPECT_NEAR(law.energy(1000.0), work, 1e-8 * work);
  FrameLaw const rigid{.stiffness = 0.0, .seating = 20e-6, .seating_force = 500.0};
  EXPECT_EQ(rigid.deflection(1000.0), 0.0);
  EXPECT_EQ(rigid.energy(1000.0), 0.0);
}

// Bed and frame in series, from a frame that hardly gives to one twice as soft as the bed, where
// the plain iteration d = D(F) would double its error in every window.
TEST(PressFrame, MeetsTheBedWhateverTheRatioOfStiffnesses) {
  for (double const ratio : {0.01, 0.3, 0.9, 1.1, 2.0}) {
    for (double const seating : {0.0, 50e-6}) {
      FrameLaw const law{
          .stiffness = stiffness / ratio, .seating = seating, .seating_force = 300.0};
      auto world = press_world();
      auto cycle = on_frame({press_to_gap(9e-3), rest(2e-3)}, law);
      Bed const bed;
      run_stage(world, cycle, bed);
      EXPECT_NEAR(cycle.commanded_gap(world), 9e-3, 1e-12);
      double const exact = balanced_gap(bed, law, 9e-3);
      double const given = exact - 9e-3;
      // While it moves: the extrapolation is exact for a straight line, the seating bends it.
      EXPECT_NEAR(punch_gap(world, cycle.faces()), exact, 2e-3 * given) << ratio << ' ' << seating;
      run_stage(world, cycle, bed);
      EXPECT_NEAR(punch_gap(world, cycle.faces()), exact, 1e-5 * given) << ratio << ' ' << seating;
      EXPECT_LT(cycle.frame().largest_error(), 0.02) << ratio << ' ' << seating;
    }
  }
}

TEST(PressFrame, RigidFrameChangesNoBit) {
  auto world = press_world(), other = press_world();
  auto cycle = programme({press_to_gap(9e-3)});
  auto framed = on_frame({press_to_gap(9e-3)}, {.stiffness = 0.0, .seating = 1e-3});
  run_stage(world, cycle);
  run_stage(other, framed);
  EXPECT_EQ(punch_gap(world, cycle.faces()), punch_gap(other, framed.faces()));
  EXPECT_EQ(framed.commanded_gap(other), punch_gap(other, framed.faces()));
}

TEST(PressFrame, AForceLimitIsReachedThroughTheFrame) {
  FrameLaw const law{.stiffness = 2e6};
  auto world = press_world();
  auto cycle = on_frame({press_to_force(500.0)}, law);
  run_stage(world, cycle);
  // The bed gives 0.5 mm, the frame 0.25 mm.
  EXPECT_NEAR(punch_gap(world, cycle.faces()), 9.5e-3, 1e-6);
  EXPECT_NEAR(cycle.commanded_gap(world), 9.25e-3, 2e-6);
}

TEST(PressFrame, GoesOnAfterARestartToTheSameBits) {
  FrameLaw const law{.stiffness = 3e6, .seating = 20e-6, .seating_force = 300.0};
  auto world = press_world();
  auto cycle = on_frame({press_to_gap(9e-3)}, law);
  cycle.start_stage(world);
  while (world.time < 0.0527)
    one_step(world, cycle);
  Memory memory;
  cycle.visit_state(memory.writer());
  auto other_world = world;
  auto other = on_frame({press_to_gap(9e-3)}, law);
  other.visit_state(memory.reader());
  while (!cycle.stage_has_ended(world)) {
    one_step(world, cycle);
    one_step(other_world, other);
  }
  EXPECT_EQ(punch_gap(world, cycle.faces()), punch_gap(other_world, other.faces()));
  EXPECT_EQ(cycle.frame().deflection(), other.frame().deflection());
}

TEST(PressFrame, CaseRefusesSeatingThatMeansNothing) {
  auto const message = [](std::vector<std::string> const& entries) -> std::string {
    try {
      parse_case("set Title = frame\n", "frame.prm", entries);
    } catch (dem::InvalidInput const& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(message({"Press frame/Seating=0.1 mm"}).find("rigid"), std::string::npos);
  EXPECT_NE(message({"Press frame/Seating=0.1 mm", "Press frame/Stiffness=100 kN/mm"})
                .find("Seating force"),
            std::string::npos);
  EXPECT_EQ(message({"Press frame/Stiffness=100 kN/mm"}), "accepted");
  EXPECT_NE(message({"Press frame/Stiffness=100 mm"}).find("stiffness"), std::string::npos);
}
