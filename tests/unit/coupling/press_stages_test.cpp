#include "coupling/press_programme.hpp"
#include "dem/expect.hpp"
#include "tests/unit/coupling/press_stand_in.hpp"

#include <gtest/gtest.h>

using namespace coupling;
using stand_in::fill_height;
using stand_in::keep_force;
using stand_in::press_to_force;
using stand_in::press_to_gap;

namespace {

std::string refusal(std::vector<Stage> const& stages) {
  try {
    validate_stages(stages, fill_height);
  } catch (dem::InvalidInput const& error) {
    return error.what();
  }
  return "accepted";
}

void expect_refused(std::vector<Stage> const& stages, std::string const& reason) {
  auto const message = refusal(stages);
  EXPECT_NE(message.find(reason), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

Stage release(std::vector<std::string> tools) {
  return {.name = "release", .kind = StageKind::release, .tools = std::move(tools)};
}

Stage changed(Stage stage, auto&& change) {
  change(stage);
  return stage;
}

} // namespace

TEST(PressStages, TheSeedsProgrammeIsAccepted) {
  Stage const unload =
      changed(press_to_gap(16e-3), [](Stage& s) { s.name = "unloading", s.speed = 0.2; });
  Stage const rest{.name = "relaxation", .kind = StageKind::free, .tools = {}, .duration = 0.05};
  EXPECT_EQ(refusal({press_to_gap(8e-3), unload, release({"die", "upper_punch"}), rest}),
            "accepted");
}

TEST(PressStages, ForceLimitsLeaveTheGapOpen) {
  // After a force the gap is not known, so a later gap cannot be refused for its direction.
  Stage const unload =
      changed(press_to_gap(16e-3), [](Stage& s) { s.name = "unloading", s.speed = 0.2; });
  EXPECT_EQ(refusal({press_to_force(500.0), keep_force(500.0, 1e-3), unload}), "accepted");
}

TEST(PressStages, RefusesWhatCannotBeRun) {
  expect_refused({}, "no stage");
  expect_refused({press_to_gap(8e-3), press_to_gap(7e-3)}, "name is used twice");
  expect_refused({changed(press_to_gap(8e-3), [](Stage& s) { s.tools = {}; })}, "names no tool");
  expect_refused({changed(press_to_gap(8e-3), [](Stage& s) { s.tools = {"hammer"}; })},
                 "tool 'hammer' is unknown");
  expect_refused({changed(press_to_gap(8e-3), [](Stage& s) { s.speed = 0.0; })}, "needs a speed");
  expect_refused({changed(press_to_gap(8e-3), [](Stage& s) { s.speed = 0.2; })},
                 "leads away from the gap");
  expect_refused({changed(press_to_gap(8e-3), [](Stage& s) { s.tools = {"die"}; })},
                 "do not approach");
  expect_refused({changed(press_to_gap(8e-3),
                          [](Stage& s) {
                            s.tools = {"upper_punch", "lower_punch"};
                          })},
                 "do not approach");
  expect_refused({press_to_gap(0.0)}, "punches meet");
  expect_refused(
      {changed(press_to_gap(8e-3), [](Stage& s) { s.until = Limit::time, s.duration = 0.11; })},
      "punches meet");
  expect_refused({changed(press_to_gap(8e-3), [](Stage& s) { s.until = Limit::time; })},
                 "duration of 0 s");
  expect_refused({{.name = "rest", .kind = StageKind::free, .tools = {}, .duration = -1.0}},
                 "duration of -1 s");
  expect_refused({release({"upper_punch"}), press_to_gap(8e-3)},
                 "was released by an earlier stage");
  Stage const eject{.name = "ejection",
                    .kind = StageKind::move,
                    .tools = {"lower_punch"},
                    .speed = 0.2,
                    .until = Limit::flush};
  EXPECT_EQ(refusal({release({"upper_punch"}), eject}), "accepted");
  expect_refused({eject}, "in the compact's way");
  expect_refused({release({"upper_punch"}), changed(eject, [](Stage& s) { s.speed = -0.2; })},
                 "no nearer to the die's rim");
  Stage const follow{.name = "measured",
                     .kind = StageKind::follow,
                     .tools = {"upper_punch"},
                     .duration = 1.0,
                     .path = {.time = {0.0, 1.0}, .gap = {12e-3, 9e-3}}};
  EXPECT_EQ(refusal({press_to_gap(12e-3), follow}), "accepted");
  expect_refused({follow}, "starts at a gap of 0.012 m, but the punches will stand 0.02 m apart");
  expect_refused({keep_force(0.0, 1e-3)}, "force above 0 N");
  expect_refused({changed(keep_force(5.0, 1e-3), [](Stage& s) { s.tools = {"die"}; })},
                 "not the die");
}

TEST(PressStages, LengthsAreExpectedFromSpeedsAndGaps) {
  Stage const rest{.name = "rest", .kind = StageKind::free, .tools = {}, .duration = 0.05};
  auto const lengths = expected_lengths(
      std::vector{press_to_gap(8e-3), release({"die"}), rest, press_to_force(10.0)}, fill_height);
  ASSERT_EQ(lengths.size(), 4u);
  EXPECT_NEAR(lengths[0], 0.06, 1e-15); // 12 mm / 0.2 m/s
  EXPECT_EQ(lengths[1], 0.0);
  EXPECT_EQ(lengths[2], 0.05);
  EXPECT_NEAR(lengths[3], 0.04, 1e-15); // until the punches would meet: 8 mm / 0.2 m/s
}
