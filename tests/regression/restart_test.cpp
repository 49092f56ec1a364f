#include "coupling/record/curves.hpp"
#include "coupling/record/run_file.hpp"
#include "tests/regression/program.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <vector>

using program::run;
using program::tiny_case;
using support::bytes_of;
using support::ScratchFolder;
namespace fs = std::filesystem;

namespace {

/// Bits of all that a user sees of two runs, but for clocks and file dates.
void expect_same_bits(fs::path const& a, fs::path const& b) {
  EXPECT_TRUE(bytes_of(a / "curves.csv") == bytes_of(b / "curves.csv"));
  EXPECT_TRUE(bytes_of(a / "grains.pvd") == bytes_of(b / "grains.pvd"));
  int n_pictures = 0;
  for (auto const& entry : fs::directory_iterator(a / "snapshots")) {
    EXPECT_TRUE(bytes_of(entry.path()) == bytes_of(b / "snapshots" / entry.path().filename()))
        << entry.path();
    ++n_pictures;
  }
  EXPECT_GE(n_pictures, 30); // 12 of grains and tools for ParaView, 12 frames
  auto const last = coupling::read_grains(a / "run.h5");
  auto const other = coupling::read_grains(b / "run.h5");
  EXPECT_TRUE(last.position == other.position);
  EXPECT_TRUE(last.velocity == other.velocity);
  EXPECT_TRUE(last.spin == other.spin);
  EXPECT_TRUE(last.force == other.force);
}

std::vector<std::string> run_into(fs::path const& folder,
                                  std::vector<std::string> const& more = {}) {
  std::vector<std::string> arguments{"run", tiny_case(), "-o", folder.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

} // namespace

TEST(Restart, AnInterruptedRunGoesOnToTheSameBits) {
  ScratchFolder scratch;
  ASSERT_EQ(run(run_into(scratch / "straight", {"--quiet", "--threads", "1"})).status, 0);
  for (int const signal : {SIGINT, SIGTERM}) {
    auto const folder = scratch / ("signal" + std::to_string(signal));
    // 25 % of the programme: in the middle of loading.
    program::Running running(run_into(folder, {"--threads", "1"}));
    ASSERT_TRUE(running.wait_for(" 25 %"));
    running.signal(signal);
    auto const outcome = running.finish();
    EXPECT_EQ(outcome.status, 130);
    EXPECT_NE(outcome.error.find("interrupted at t ="), std::string::npos) << outcome.error;
    EXPECT_NE(outcome.error.find("presscheck resume " + folder.string()), std::string::npos)
        << outcome.error;
    EXPECT_FALSE(fs::exists(folder / "summary.json"));
    ASSERT_EQ(run({"resume", folder.string(), "--quiet", "--threads", "1"}).status, 0);
    expect_same_bits(scratch / "straight", folder);
  }
}

TEST(Restart, StageByStageGivesTheSameBits) {
  ScratchFolder scratch;
  ASSERT_EQ(run(run_into(scratch / "straight", {"--quiet", "--threads", "1"})).status, 0);
  auto const folder = scratch / "steps";
  ASSERT_EQ(run(run_into(folder, {"--quiet", "--threads", "1", "--until", "loading"})).status, 0);
  ASSERT_EQ(
      run({"resume", folder.string(), "--quiet", "--threads", "1", "--until", "release"}).status,
      0);
  ASSERT_EQ(run({"resume", folder.string(), "--quiet", "--threads", "1"}).status, 0);
  expect_same_bits(scratch / "straight", folder);
}

TEST(Restart, AReleaseBetweenTwoBuildsOfTheListsGoesOnToTheSameBits) {
  ScratchFolder scratch;
  // With these values the lists of neighbours from before the release still hold after it, walls
  // included.
  std::vector<std::string> const values{"--quiet",
                                        "--threads",
                                        "1",
                                        "--set",
                                        "Powder/Component 1/Young's modulus=30 MPa",
                                        "--set",
                                        "Powder/Component 2/Young's modulus=30 MPa",
                                        "--set",
                                        "Tooling/Young's modulus=240 MPa",
                                        "--set",
                                        "Contact/Particle-particle/Cohesion energy density=2e5"};
  ASSERT_EQ(run(run_into(scratch / "straight", values)).status, 0);
  auto until_release = values;
  until_release.insert(until_release.end(), {"--until", "release"});
  auto const folder = scratch / "steps";
  ASSERT_EQ(run(run_into(folder, until_release)).status, 0);
  ASSERT_EQ(run({"resume", folder.string(), "--quiet", "--threads", "1"}).status, 0);
  expect_same_bits(scratch / "straight", folder);
}

TEST(Restart, RestartsWrittenOnTheWayChangeNothing) {
  ScratchFolder scratch;
  ASSERT_EQ(run(run_into(scratch / "straight", {"--quiet", "--threads", "1"})).status, 0);
  ASSERT_EQ(run(run_into(scratch / "often",
                         {"--quiet", "--threads", "1", "--set", "Output/Restart interval=20 ms"}))
                .status,
            0);
  expect_same_bits(scratch / "straight", scratch / "often");
}

TEST(Restart, AFinishedRunResumesToItsOwnResults) {
  ScratchFolder scratch;
  ASSERT_EQ(run(run_into(scratch / "out", {"--quiet", "--threads", "1"})).status, 0);
  auto const curves = bytes_of(scratch / "out/curves.csv");
  ASSERT_EQ(run({"resume", (scratch / "out").string(), "--quiet"}).status, 0);
  EXPECT_TRUE(bytes_of(scratch / "out/curves.csv") == curves);
}

TEST(Restart, TheReportCanBeRebuilt) {
  ScratchFolder scratch;
  ASSERT_EQ(run(run_into(scratch / "out", {"--quiet", "--threads", "1"})).status, 0);
  auto const report = bytes_of(scratch / "out/report.html");
  fs::remove(scratch / "out/report.html");
  auto const outcome = run({"report", (scratch / "out").string()});
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(bytes_of(scratch / "out/report.html").size(), report.size());
}

TEST(Threads, GiveTheSameBits) {
  ScratchFolder scratch;
  for (auto const* threads : {"1", "2", "4"})
    ASSERT_EQ(run(run_into(scratch / threads, {"--quiet", "--threads", threads})).status, 0);
  expect_same_bits(scratch / "1", scratch / "2");
  expect_same_bits(scratch / "1", scratch / "4");
}

TEST(Threads, GiveTheSameBitsOfABedOfManyBlocks) {
  ScratchFolder scratch;
  // 2204 grains, 0.4 mm of stroke: 1778 steps in which cohesive grains collide and the punch
  // gathers the first of them.
  for (auto const* threads : {"1", "2", "4"})
    ASSERT_EQ(
        run({"run", PRESSCHECK_SOURCE_DIR "/cases/quick/case.prm", "-o",
             (scratch / threads).string(), "--quiet", "--threads", threads, "--until", "loading",
             "--set", "Press programme/Stage 1/Gap=19.6 mm", "--set",
             "Press programme/Stage 2/Gap=20 mm", "--set", "Output/Snapshot interval=0.15 ms"})
            .status,
        0);
  expect_same_bits(scratch / "1", scratch / "2");
  expect_same_bits(scratch / "1", scratch / "4");
}
