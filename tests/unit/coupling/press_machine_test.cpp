#include "coupling/load_cell.hpp"
#include "coupling/record/restart_file.hpp"
#include "tests/regression/tiny_press.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace coupling;
using support::ScratchFolder;

namespace {

/// The record of the tiny press up to the end of its unloading, while both punches are there.
PressRecord record_of(std::vector<std::string> const& changes) {
  ScratchFolder scratch;
  Press press = tiny::press(changes);
  tiny::run(press, scratch.path(), "unloading");
  return press.record;
}

} // namespace

TEST(PressMachine, PunchFacesStandOffByTheGapOffset) {
  for (double const offset : {0.1e-3, -0.1e-3}) {
    auto const record =
        record_of({"Press frame/Gap offset=" + std::to_string(1e3 * offset) + " mm"});
    auto const shown = record.column("punch_gap"), real = record.column("bed_height");
    for (std::size_t k = 0; k < record.size(); ++k)
      EXPECT_NEAR(real[k] - shown[k], offset, 1e-12) << k;
    EXPECT_NEAR(*std::ranges::min_element(shown), 4.4e-3, 1e-9); // as the machine was told
  }
}

TEST(PressMachine, DriftsAwayWithTime) {
  auto const record = record_of({"Press frame/Thermal drift=5 mm/s"});
  auto const time = record.column("time");
  auto const shown = record.column("punch_gap"), real = record.column("bed_height");
  for (std::size_t k = 0; k < record.size(); ++k)
    EXPECT_NEAR(real[k] - shown[k], 5e-3 * time[k], 1e-10) << k;
}

TEST(PressMachine, ANegativeOffsetPressesHarder) {
  auto const peak = [](PressRecord const& record) {
    auto const force = record.column("upper_punch_force");
    return *std::ranges::max_element(force);
  };
  // A tiny bed packs differently each time: by 10 % of its peak.
  EXPECT_GT(peak(record_of({"Press frame/Gap offset=-0.4 mm"})),
            1.5 * peak(record_of({"Press frame/Gap offset=0.4 mm"})));
}

TEST(PressMachine, LoadCellShowsTheForceThroughItsErrors) {
  auto const record =
      record_of({"Load cell/Gain=1.02", "Load cell/Offset=-3 N", "Load cell/Drift=50 N/s"});
  auto const time = record.column("time");
  auto const force = record.column("upper_punch_force"),
             shown = record.column("upper_punch_reading");
  double largest = 0.0;
  for (std::size_t k = 1; k < record.size(); ++k) {
    EXPECT_NEAR(shown[k], 1.02 * force[k] - 3.0 + 50.0 * time[k], 1e-9) << k;
    largest = std::max(largest, force[k]);
  }
  EXPECT_GT(largest, 1.0);
}

/// A ramp F = c t through a lag of first order:  y = c (t - tau (1 - exp(-t / tau))).
TEST(LoadCell, LagsByItsTimeConstant) {
  double const tau = 0.02, c = 1000.0;
  for (double const dt : {1e-4, 5e-3, 0.05}) { // exact for a ramp, whatever the step
    LoadCell cell({.lag = tau});
    double t = 0.0;
    while (t < 0.05 - 0.5 * dt) {
      t += dt;
      cell.step_done(c * t, dt);
    }
    EXPECT_NEAR(cell.reading(), c * (t + tau * std::expm1(-t / tau)), 1e-10 * c);
  }
}

TEST(PressMachine, GoesOnFromARestartToTheSameBits) {
  std::vector<std::string> const all{"Press frame/Gap offset=0.05 mm",
                                     "Press frame/Thermal drift=1 mm/s",
                                     "Load cell/Time constant=1 ms", "Load cell/Drift=50 N/s"};
  ScratchFolder scratch;
  Press whole = tiny::press(all);
  tiny::run(whole, scratch / "whole", "unloading");
  Press first = tiny::press(all);
  tiny::run(first, scratch / "part", "loading");
  Press second = restore_press(tiny::read(all), stage_restart(scratch / "part", "loading"));
  tiny::run(second, scratch / "part", "unloading");
  EXPECT_EQ(whole.record.rows(), second.record.rows());
}
