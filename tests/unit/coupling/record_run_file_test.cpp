#include "coupling/record/run_file.hpp"

#include "coupling/record/h5.hpp"
#include "coupling/record/restart_file.hpp"
#include "dem/expect.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using coupling::H5Reader;
using support::ScratchFolder;

namespace {

/// Two grains that stand in memory against the order of their ids.
dem::Spheres two_grains() {
  dem::Spheres grains;
  grains.add({1.0, 2.0, 3.0}, 2e-3, 1000.0, 1, {0.5, 0.0, 0.0});
  grains.add({4.0, 5.0, 6.0}, 1e-3, 2000.0, 0);
  grains.id = {1, 0};
  return grains;
}

coupling::PressRecord two_rows() {
  coupling::PressRecord record({{"time", "s"}, {"upper_punch_force", "N"}});
  record.add_row("loading", {0.0, 1.0});
  record.add_row("dwell", {0.1, 2.0});
  return record;
}

} // namespace

TEST(RunFile, HoldsCurvesSummaryGrainsSnapshotsAndProvenance) {
  ScratchFolder const folder;
  coupling::Summary summary;
  summary.max_force = 2.0;
  summary.checks = {{"energy", 0.1, 0.2, true}, {"axial balance", 0.3, 0.2, false}};
  coupling::write_grain_frame(folder / "grains_000001.h5", 0.05, "loading", two_grains());
  coupling::write_run_file(
      folder / "run.h5", two_rows(), summary,
      {.version = "0.1.0", .case_text = "set x = 1\n", .seed = 42, .threads = 2}, two_grains(),
      {"grains_000001.h5"});

  H5Reader const run(folder / "run.h5");
  EXPECT_EQ(run.get<std::vector<double>>("curves/upper_punch_force"),
            (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(run.attribute("curves/upper_punch_force", "unit"), "N");
  EXPECT_EQ(run.get<std::vector<std::string>>("curves/stage"),
            (std::vector<std::string>{"loading", "dwell"}));
  EXPECT_EQ(run.get<double>("summary/max_force"), 2.0);
  EXPECT_EQ(run.attribute("summary/max_force", "unit"), "N");
  EXPECT_EQ(run.get<std::vector<std::uint8_t>>("summary/checks/ok"),
            (std::vector<std::uint8_t>{1, 0}));
  EXPECT_EQ(run.get<std::vector<std::string>>("summary/checks/name")[1], "axial balance");
  EXPECT_EQ(run.get<std::string>("provenance/case_text"), "set x = 1\n");
  EXPECT_EQ(run.get<std::uint64_t>("provenance/seed"), 42u);
  EXPECT_EQ(run.get<int>("provenance/threads"), 2);
  // Through the link into the frame's own file.
  EXPECT_EQ(run.get<double>("snapshots/grains_000001/time"), 0.05);
  EXPECT_EQ(run.get<std::vector<double>>("snapshots/grains_000001/grains/radius"),
            (std::vector<double>{1e-3, 2e-3}));
  // Everything with a unit says so.
  for (auto const& name : run.datasets()) {
    bool const is_number =
        name.starts_with("curves/") ? name != "curves/stage" : name.starts_with("grains/");
    if (is_number) {
      EXPECT_NE(run.attribute(name, "unit"), "") << name;
    }
  }
}

TEST(RunFile, WritesGrainsInTheOrderOfTheirIds) {
  ScratchFolder const folder;
  dem::Spheres const before = two_grains();
  coupling::write_grain_frame(folder / "frame.h5", 0.0, "", before);
  dem::Spheres const after = coupling::read_grains(folder / "frame.h5");
  EXPECT_EQ(after.id, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(after.position[0], before.position[1]);
  EXPECT_EQ(after.velocity[1], before.velocity[0]);
  EXPECT_EQ(after.mass[0], before.mass[1]);
  EXPECT_EQ(after.material, (std::vector<std::uint8_t>{0, 1}));
}

TEST(RunFile, GrainsComeFromARestartTooAndNotFromOtherFiles) {
  ScratchFolder const folder;
  dem::Spheres const before = two_grains();
  {
    coupling::StateWriter writer(folder / "restart_1.h5", coupling::RestartHeader{});
    writer("grains/position", before.position);
    writer("grains/velocity", before.velocity);
    writer("grains/spin", before.spin);
    writer("grains/force", before.force);
    writer("grains/torque", before.torque);
    writer("grains/radius", before.radius);
    writer("grains/mass", before.mass);
    writer("grains/material", before.material);
    writer("grains/id", before.id);
    writer.commit();
  }
  EXPECT_EQ(coupling::read_grains(folder / "restart_1.h5").position,
            before.position); // in their order there
  coupling::H5Writer other(folder / "other.h5");
  other.write("x", 1.0);
  other.commit();
  EXPECT_THROW(coupling::read_grains(folder / "other.h5"), dem::InvalidInput);
}
