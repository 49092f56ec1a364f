#include "coupling/case_file.hpp"

#include "dem/expect.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

// A press programme that cannot be run: each refusal by its
// whole message.
namespace coupling {
namespace {

/// The message with which a case with these overrides is refused, without the place `--set: `.
std::string refusal(std::vector<std::string> const& overrides) {
  try {
    parse_case("set Mode = rigid\n", "case.prm", overrides);
    return "accepted";
  } catch (dem::InvalidInput const& problem) {
    std::string const message = problem.what();
    return message.starts_with("--set: ") ? message.substr(7) : message;
  }
}

std::string const stage_1 = "Press programme/Stage 1/";

TEST(Entries, OfAbsentComponentsAndStagesAreRefused) {
  EXPECT_EQ(refusal({"Powder/Component 4/Density=2000 kg/m^3"}),
            "Powder/Component 4/Density = 2000 kg/m^3: is not used (component 4 is absent while "
            "its Name is empty). Remove "
            "it?");
  EXPECT_EQ(refusal({"Press programme/Stage 7/Speed=1 mm/s"}),
            "Press programme/Stage 7/Speed = 1 mm/s: is not used (stage 7 is absent while its Kind "
            "is none). Remove it?");
  EXPECT_EQ(
      refusal({stage_1 + "Until=time", stage_1 + "Duration=0.05 s", stage_1 + "Gap=8 mm"}),
      "Press programme/Stage 1/Gap = 8 mm: is not used (Kind = move, Until = time). Remove it?");
}

TEST(Programme, WithoutStagesIsRefused) {
  EXPECT_EQ(refusal({stage_1 + "Kind=none", "Press programme/Stage 2/Kind=none",
                     "Press programme/Stage 3/Kind=none", "Press programme/Stage 4/Kind=none"}),
            "Press programme/Stage 1/Kind = none: leaves the press programme without a stage "
            "(there is nothing to run). Set "
            "it to move?");
}

TEST(Stage, WithAnUnknownToolIsRefused) {
  EXPECT_EQ(refusal({stage_1 + "Tools=upper punch"}),
            "Press programme/Stage 1/Tools = upper punch: names an unknown tool 'upper punch' "
            "(tools are die, upper_punch, "
            "lower_punch). Did you mean 'upper_punch'?");
  EXPECT_EQ(
      refusal({stage_1 + "Tools="}),
      "Press programme/Stage 1/Tools = : names no tool (a move needs one). Name upper_punch?");
  EXPECT_EQ(refusal({stage_1 + "Tools=die, die"}),
            "Press programme/Stage 1/Tools = die, die: names 'die' twice. Name it once?");
}

TEST(Stage, WithoutALimitOrMotionIsRefused) {
  EXPECT_EQ(refusal({stage_1 + "Until=time"}),
            "case.prm: Press programme/Stage 1/Duration = 0 s (default): sets no limit (a move "
            "until a time needs one). Give "
            "it a value above 0?");
  EXPECT_EQ(refusal({stage_1 + "Until=force"}),
            "case.prm: Press programme/Stage 1/Force = 0 N (default): sets no limit (a move until "
            "a force needs one). Give "
            "it a value above 0?");
  EXPECT_EQ(refusal({stage_1 + "Gap=0 mm"}),
            "Press programme/Stage 1/Gap = 0 mm: sets no limit (a move until a gap needs one). "
            "Give it a value above 0?");
  EXPECT_EQ(refusal({stage_1 + "Speed=0 m/s"}),
            "Press programme/Stage 1/Speed = 0 m/s: moves nothing. Give it a speed, positive up, "
            "or choose Kind = hold?");
  EXPECT_EQ(refusal({"Press programme/Stage 4/Servo=true", "Press programme/Stage 4/Kind=hold"}),
            "case.prm: Press programme/Stage 4/Tools =  (default): is not the one punch that a "
            "servo drives. Name "
            "upper_punch or lower_punch?");
}

TEST(Stage, ThatDoesNotFollowFromTheOthersIsRefusedAtItsPlace) {
  // The punch starts at 20 mm and cannot come down to 25 mm.
  std::string const up = refusal({stage_1 + "Gap=25 mm"});
  EXPECT_TRUE(
      up.starts_with("case.prm: Press programme/Stage 1/Kind = move (default): stage 'loading': "))
      << up;
  // A released tool does not move.
  std::string const gone =
      refusal({"Press programme/Stage 4/Kind=move", "Press programme/Stage 4/Tools=upper_punch",
               "Press programme/Stage 4/Speed=0.1 m/s"});
  EXPECT_TRUE(gone.starts_with("Press programme/Stage 4/Kind = move: stage 'relaxation': "))
      << gone;
  EXPECT_EQ(refusal({"Press programme/Stage 4/Name=loading"}),
            "Press programme/Stage 4/Name = loading: is the name of an earlier stage (results are "
            "kept by name). Rename "
            "one?");
  EXPECT_EQ(refusal({stage_1 + "Name=../../etc"}),
            "Press programme/Stage 1/Name = ../../etc: is no name (at most 40 bytes, without , ; "
            "\" ' / \\ < >). Choose a "
            "plainer one?");
}

TEST(Stage, FasterThanTheTimeStepCanFollowIsRefused) {
  // Alumina of 0.5 mm: Rayleigh time 4.689e-6 s, step 4.689e-7 s; 40 m/s 4.689e-7 s / 0.25 mm =
  // 0.075
  EXPECT_EQ(refusal({stage_1 + "Speed=-40 m/s"}),
            "Press programme/Stage 1/Speed = -40 m/s: moves 0.075 grain radii per step (limit "
            "0.05). Lower the speed or the "
            "time step?");
  EXPECT_EQ(refusal({stage_1 + "Speed=-26 m/s"}), "accepted"); // 0.0488
}

} // namespace
} // namespace coupling
