#include "coupling/press_cycle.hpp"

#include "coupling/press_measures.hpp"
#include "dem/expect.hpp"
#include "dem/measure/shape.hpp"
#include "tests/regression/tiny_press.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace coupling;
using support::ScratchFolder;

namespace {

/// One cycle of the tiny press for all tests that only look.
struct Cycle {
  ScratchFolder scratch;
  Press press = tiny::press();
  Cycle() { tiny::run(press, scratch.path()); }
};

Cycle const& cycle() {
  static Cycle const done;
  return done;
}

double at(PressRecord const& record, std::string_view column, std::size_t row) {
  return record.column(column)[row];
}

/// Row of the largest upper punch force.
std::size_t peak_row(PressRecord const& record) {
  auto const force = record.column("upper_punch_force");
  return static_cast<std::size_t>(std::ranges::max_element(force) - force.begin());
}

/// The last row of a stage.
std::size_t last_row(PressRecord const& record, std::string const& stage) {
  std::size_t row = 0;
  for (std::size_t k = 0; k < record.size(); ++k)
    if (record.stages()[k] == stage)
      row = k;
  return row;
}

} // namespace

TEST(PressCycle, RecordsAtItsIntervalAndAtEachStagesEnd) {
  auto const& record = cycle().press.record;
  // 23 ms at 0.1 ms are 230 rows, one more at the start, one at the end of the release; peaks may
  // add some.
  EXPECT_GE(record.size(), 232u);
  EXPECT_LE(record.size(), 245u);
  EXPECT_EQ(at(record, "time", 0), 0.0);
  EXPECT_EQ(at(record, "time", last_row(record, "loading")), 9e-3);
  EXPECT_NEAR(at(record, "punch_gap", last_row(record, "loading")), 4.4e-3, 1e-12);
  EXPECT_NEAR(at(record, "time", record.size() - 1), 23e-3, 1e-15);
  EXPECT_TRUE(std::ranges::is_sorted(record.column("time")));
}

TEST(PressCycle, ForcesHaveTheSignsOfASqueezedBed) {
  auto const& record = cycle().press.record;
  auto const row = peak_row(record);
  EXPECT_EQ(record.stages()[row], "loading");
  double const upper = at(record, "upper_punch_force", row);
  double const lower = at(record, "lower_punch_force", row);
  double const wall = at(record, "wall_axial_force", row);
  EXPECT_GT(upper, 1.0);
  EXPECT_GT(lower, 1.0);
  EXPECT_GT(wall, 0.0); // the bed drags the die down while it is pressed from above
  EXPECT_LT(wall, 0.3 * upper);
  EXPECT_GT(at(record, "wall_radial_pressure", row), 0.0);
  // Weight (2.9 mN) and inertia are small against 1 N: what goes in at the top comes out below and
  // at the wall.
  EXPECT_NEAR(upper, lower + wall, 0.05 * upper);
}

TEST(PressCycle, AxialForcesBalanceTheBedsInertia) {
  auto const& record = cycle().press.record;
  double const peak = at(record, "upper_punch_force", peak_row(record));
  for (double const imbalance : record.column("axial_imbalance"))
    EXPECT_LT(std::abs(imbalance), 1e-5 * peak);
}

TEST(PressCycle, EnergyIsAccountedFor) {
  auto const& record = cycle().press.record;
  auto const work = record.column("tool_work");
  double const peak = *std::ranges::max_element(work);
  for (double const error : record.column("energy_error"))
    EXPECT_LT(std::abs(error), 0.01 * peak);
  // Each entry of the ledger is there: a bed that is pressed and relaxes stores, rubs and damps.
  auto const row = peak_row(record);
  EXPECT_GT(at(record, "elastic_energy", row), 0.05 * peak);
  EXPECT_LT(at(record, "cohesive_energy", row), -0.02 * peak);
  EXPECT_GT(at(record, "tangential_work", row), 0.05 * peak);
  EXPECT_GT(at(record, "normal_damping_loss", row), 0.01 * peak);
  EXPECT_GT(at(record, "released_energy", record.size() - 1),
            0.0); // the die took its contacts' energy along
}

TEST(PressCycle, TheSummaryAgreesWithTheRecord) {
  auto const& press = cycle().press;
  auto const summary = summarise(press);
  auto const& record = press.record;
  double const recorded = at(record, "upper_punch_force", peak_row(record));
  EXPECT_GE(summary.max_force, recorded);
  EXPECT_LE(summary.max_force, 1.005 * recorded);
  auto const unloaded = last_row(record, "unloading");
  EXPECT_NEAR(summary.compact_height, at(record, "compact_height", unloaded), 1e-12);
  EXPECT_NEAR(summary.springback, summary.compact_height / 4.4e-3 - 1.0, 1e-9);
  EXPECT_GT(summary.springback, 0.0);
  EXPECT_GT(summary.porosity, summary.porosity_core); // the highest grain overstates the height
  EXPECT_GT(summary.porosity_core, 0.2);
  EXPECT_EQ(summary.shape_quality, dem::shape_quality(summary.shape_similarity));
  EXPECT_GT(summary.shape_similarity, 0.9);
  EXPECT_EQ(summary.steps, press.world.step);
  EXPECT_EQ(summary.grains, press.world.grains.size());
  ASSERT_EQ(summary.tools.size(), 3u);
  EXPECT_TRUE(std::isnan(summary.tools[0].max_von_mises)); // a rigid tool knows no stress
}

TEST(PressCycle, ItsChecksHold) {
  auto const summary = summarise(cycle().press);
  EXPECT_GE(summary.checks.size(), 6u);
  for (Check const& check : summary.checks)
    EXPECT_TRUE(check.ok) << check.name << ": " << check.value;
}

TEST(PressCycle, WhatWasNotReachedIsUnknown) {
  ScratchFolder scratch;
  auto press = tiny::press({"Press programme/Stage 1/Gap=7.5 mm"});
  EXPECT_EQ(tiny::run(press, scratch.path(), "loading"), RunEnd::stage_reached);
  auto const summary = summarise(press);
  EXPECT_TRUE(std::isnan(summary.porosity));
  EXPECT_TRUE(std::isnan(summary.shape_similarity));
  EXPECT_EQ(summary.shape_quality, 0);
}

TEST(PressCycle, APressThatKeepsItsDieIsMeasuredWhereItEnds) {
  ScratchFolder scratch;
  Case setup = tiny::read({"Press programme/Stage 1/Gap=7.5 mm"});
  setup.stages.resize(1);
  auto press = set_up_press(setup);
  EXPECT_EQ(tiny::run(press, scratch.path()), RunEnd::finished);
  EXPECT_TRUE(std::isfinite(summarise(press).porosity));
}

TEST(PressCycle, TheLowerPunchPushesTheCompactOutAgainstTheWallsFriction) {
  ScratchFolder scratch;
  auto const eject = [&](char const* friction, char const* folder) {
    Case setup = tiny::read(
        {std::string("Contact/Particle-wall/Coefficient of static friction=") + friction});
    setup.stages.resize(2);
    setup.stages.push_back({.name = "open", .kind = StageKind::release, .tools = {"upper_punch"}});
    setup.stages.push_back({.name = "ejection",
                            .kind = StageKind::move,
                            .tools = {"lower_punch"},
                            .speed = 0.4,
                            .until = Limit::flush});
    auto press = set_up_press(setup);
    EXPECT_EQ(tiny::run(press, scratch / folder), RunEnd::finished);
    EXPECT_NEAR(tool_named(press.world, "lower_punch").displacement.z(), 8e-3, 1e-12);
    return press;
  };
  // Rows with the whole compact below the rim: at the rim a grain leans on its edge.
  auto const rows_inside = [](PressRecord const& record) {
    std::vector<std::size_t> rows;
    double start = 0.0;
    for (std::size_t row = 0; row < record.size(); ++row) {
      if (record.stages()[row] != "ejection")
        start = at(record, "time", row);
      else if (0.4 * (at(record, "time", row) - start) + at(record, "compact_height", row) < 8e-3)
        rows.push_back(row);
    }
    return rows;
  };
  auto const rough = eject("0.3", "rough");
  auto const& record = rough.record;
  double largest = 0.0, most_mobilised = 0.0;
  for (std::size_t const row : rows_inside(record)) {
    double const normal = at(record, "wall_radial_pressure", row) * dem::pi * 6e-3 *
                          at(record, "compact_height", row);
    double const friction = -at(record, "wall_axial_force", row);
    EXPECT_LE(friction, 0.3 * normal * (1.0 + 1e-6));
    most_mobilised = std::max(most_mobilised, friction / (0.3 * normal));
    largest = std::max(largest, at(record, "lower_punch_force", row));
  }
  EXPECT_GT(most_mobilised, 0.9); // everything slides
  EXPECT_GE(summarise(rough).ejection_force, largest);
  auto const smooth = eject("0", "smooth");
  for (std::size_t const row : rows_inside(smooth.record))
    EXPECT_NEAR(at(smooth.record, "wall_axial_force", row), 0.0, 1e-9);
  EXPECT_TRUE(std::isnan(summarise(cycle().press).ejection_force)); // nothing was pushed out
}

TEST(PressCycle, AServoHoldsTheForceOfABedOfGrains) {
  ScratchFolder scratch;
  // The bed gives about 1e4 N/m and weighs 0.3 g: tau = 4 sqrt(m/k) = 0.7 ms, and the loop settles
  // in ten of them.
  Case setup = tiny::read();
  setup.stages[0].until = Limit::force;
  setup.stages[0].force = 4.0;
  setup.stages[1] = {.name = "dwell",
                     .kind = StageKind::hold,
                     .tools = {"upper_punch"},
                     .duration = 15e-3,
                     .force = 5.0,
                     .servo = true};
  auto press = set_up_press(setup);
  tiny::run(press, scratch.path(), "dwell");
  auto const& record = press.record;
  double sum = 0.0;
  int n = 0;
  for (std::size_t row = 0; row < record.size(); ++row) {
    if (record.stages()[row] != "dwell" ||
        at(record, "time", row) < at(record, "time", record.size() - 1) - 5e-3)
      continue;
    sum += at(record, "upper_punch_force", row);
    ++n;
  }
  ASSERT_GE(n, 45);
  EXPECT_NEAR(sum / n, 5.0, 0.05);
}

TEST(PressCycle, AnInterruptionWritesARestart) {
  ScratchFolder scratch;
  auto press = tiny::press();
  std::ostringstream nowhere;
  RunFolder files(scratch.path(), 0.0);
  Progress progress(nowhere, ProgressStyle::silent);
  int asked = 0;
  EXPECT_EQ(PressCycle(press, files, progress, [&] { return ++asked == 100; }).run(""),
            RunEnd::interrupted);
  EXPECT_EQ(press.world.step, 100u);
  EXPECT_TRUE(std::filesystem::exists(scratch / "restart_100.h5"));
}
