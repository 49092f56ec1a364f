#include "coupling/press_measures.hpp"
#include "tests/regression/tiny_press.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

/// Ways in which a press may differ from the quick case, with rigid tools, move what its
/// laboratory would measure: by five times the tolerance of a measured curve, 0.3 % of the peak,
/// and five times the scatter between packing seeds (quick_test.cpp: 1 % of the peak, 0.06 mm of
/// the height).
namespace {

struct Outcome {
  double force;  ///< [N], largest
  double height; ///< [m], of the compact after unloading
};

Outcome outcome(std::vector<std::string> changes) {
  changes.insert(changes.end(), {"Mode=rigid", "Output/Snapshot interval=0 s"});
  support::ScratchFolder scratch;
  auto press = coupling::set_up_press(
      coupling::read_case(PRESSCHECK_SOURCE_DIR "/cases/quick/case.prm", changes));
  tiny::run(press, scratch.path(), "unloading");
  auto const summary = coupling::summarise(press);
  for (auto const& check : summary.checks)
    EXPECT_TRUE(check.ok) << check.name << ": " << check.value;
  return {.force = summary.max_force, .height = summary.compact_height};
}

Outcome const& nominal() {
  static Outcome const once = outcome({});
  return once;
}

struct Mechanism {
  std::string name;
  std::vector<std::string> changes;
  double force;  ///< [1], least change over the peak, with its sign; 0: not judged
  double height; ///< [m], least change, with its sign; 0: not judged

  friend std::ostream& operator<<(std::ostream& out, Mechanism const& m) { return out << m.name; }
};

std::vector<Mechanism> mechanisms() {
  return {{"multi_contact", {"Contact/Multi-contact coefficient=0.3"}, 0.05, 0.0},
          {"punch_tilt", {"Tooling/Punch tilt=2 mm"}, 0.0, 0.3e-3},
          {"added_fines",
           {"Powder/Added fines/Share=25 %", "Powder/Added fines/Diameter=0.8 mm"},
           0.0,
           -0.3e-3}};
}

class QuickMechanism : public ::testing::TestWithParam<Mechanism> {};

TEST_P(QuickMechanism, IsSeenInThePress) {
  Mechanism const& mechanism = GetParam();
  Outcome const changed = outcome(mechanism.changes);
  auto const expect_beyond = [](double change, double least) {
    if (least != 0.0) {
      EXPECT_GT(change / least, 1.0) << change;
    }
  };
  expect_beyond(changed.force / nominal().force - 1.0, mechanism.force);
  expect_beyond(changed.height - nominal().height, mechanism.height);
}

INSTANTIATE_TEST_SUITE_P(Each, QuickMechanism, ::testing::ValuesIn(mechanisms()),
                         [](auto const& p) { return p.param.name; });

} // namespace
