#include "coupling/record/curves.hpp"
#include "coupling/record/summary_file.hpp"
#include "tests/regression/program.hpp"
#include "tests/support/scratch_folder.hpp"

#include <fmt/format.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace fs = std::filesystem;

namespace {

/// What `contract` says of a run folder, or nothing where this copy of the project has no contract
/// beside it.
std::string departures_from_contract(fs::path const& folder) {
  fs::path const contract = PRESSCHECK_SOURCE_DIR "/../shared/check/contract";
  if (!fs::exists(contract))
    return "";
  auto const verdict = folder.string() + ".contract";
  int const status = std::system(
      (contract.string() + " run " + folder.string() + " > " + verdict + " 2>&1").c_str());
  return status == 0 ? "" : support::bytes_of(verdict);
}

/// Frames of a tool's series of stresses that are listed and there.
std::size_t frames_of(fs::path const& folder, std::string const& tool) {
  std::string const listed = support::bytes_of(folder / (tool + "_stress.pvd"));
  std::size_t k = 0;
  for (std::string name;; ++k) {
    name = fmt::format("snapshots/{}_stress_{:04d}.vtu", tool, k);
    if (listed.find('"' + name + '"') == std::string::npos || !fs::exists(folder / name))
      return k;
  }
}

} // namespace

/// cases/quick from the command line, as a new user runs it. Over the packing seeds 1 to 4 it gave,
/// with standard deviations: force 1842 +- 18 N, porosity 0.3752 +- 0.0034, of the core 0.3320 +-
/// 0.0011. The ranges are about three (core: six) of them, not digits.
TEST(QuickCase, GivesItsKnownResultsAndHoldsTheContract) {
  support::ScratchFolder scratch;
  auto const folder = scratch / "quick";
  auto const outcome =
      program::run({"run", PRESSCHECK_SOURCE_DIR "/cases/quick/case.prm", "-o", folder.string(),
                    "--quiet", "--set", "Deformable tools/Stress interval=10 ms"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(departures_from_contract(folder), "");
  auto const summary = coupling::read_summary(folder / "summary.json");
  EXPECT_EQ(summary.grains, 2204u);
  EXPECT_GT(summary.max_force, 1780.0); // [N]
  EXPECT_LT(summary.max_force, 1900.0);
  EXPECT_GT(summary.porosity, 0.360);
  EXPECT_LT(summary.porosity, 0.390);
  EXPECT_GT(summary.porosity_core, 0.325);
  EXPECT_LT(summary.porosity_core, 0.340);
  EXPECT_EQ(summary.shape_quality, 5);
  for (auto const& check : summary.checks)
    EXPECT_TRUE(check.ok) << check.name << ": " << check.value;
  for (auto const* file : {"tools.pvd", "grains.pvd", "report.html", "run.h5", "geometry/die.stl",
                           "restart_stage_release.h5", "snapshots/die_peak.vtu"})
    EXPECT_TRUE(fs::exists(folder / file)) << file;
  EXPECT_NE(support::bytes_of(folder / "report.html").find("tools-canvas\""), std::string::npos);
  // A frame of stress per 10 ms while a tool is there: the die is released after 100 of 150 ms.
  EXPECT_EQ(frames_of(folder, "die"), 9u);
  EXPECT_EQ(frames_of(folder, "lower_punch"), 14u);
}
