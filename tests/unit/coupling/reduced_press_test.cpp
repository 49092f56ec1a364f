#include "coupling/reduced/press_chain.hpp"
#include "dem/expect.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

using namespace coupling;
using namespace coupling::reduced;

namespace {

double const pi = std::acos(-1.0);

BedLaw const law{.stiffness = 400e6,
                 .cohesion = 15e6,
                 .onset = 0.6,
                 .exponent = 1.6,
                 .recovery = 0.7,
                 .wall_friction = 0.2,
                 .radial_ratio = 0.45,
                 .opening = 2.5,
                 .reversal = 2e-5};
Bed const bed{.solid_area = 7e-3, .bore = 22e-3};
GapCourse const course = press_course(20e-3, 8e-3, 0.2, 0.1, 0.01);

std::vector<double> samples() {
  std::vector<double> t(400);
  std::iota(t.begin(), t.end(), 0.0);
  for (double& at : t)
    at *= 0.19 / 399.0;
  return t;
}

std::vector<ChainReading> cycle(FrameLaw const& frame = {}, LoadCellErrors const& cell = {},
                                BedLaw const& with = law) {
  return press_cycle({.law = with, .bed = bed}, {.frame = frame, .load_cell = cell}, course,
                     samples());
}

double peak(std::vector<ChainReading> const& readings) {
  double most = 0.0;
  for (auto const& r : readings)
    most = std::max(most, r.forces.upper);
  return most;
}

} // namespace

TEST(PressChain, RigidMachineShowsWhatIs) {
  for (auto const& r : cycle()) {
    EXPECT_EQ(r.height, r.commanded_gap);
    EXPECT_EQ(r.load_cell, r.forces.upper);
  }
  EXPECT_NEAR(peak(cycle()), bed_forces(law, bed, 8e-3, 8e-3).upper, 1e-9);
}

TEST(PressChain, HeightIsWhereBedAndFrameAgree) {
  FrameLaw const frame{.stiffness = 30e6,
                       .seating = 0.1e-3,
                       .seating_force = 2e3,
                       .gap_offset = 0.15e-3,
                       .thermal_drift = 1e-3};
  double largest = 0.0;
  for (auto const& r : cycle(frame)) {
    double const given = frame.deflection(r.forces.upper);
    EXPECT_NEAR(r.height, r.commanded_gap + 0.15e-3 + 1e-3 * r.time + given, 1e-12);
    largest = std::max(largest, given);
  }
  EXPECT_GT(largest, 0.2e-3);
}

/// The frame of the grains' simulator on the same bed, stepped as it is there, while it closes. (At
/// the end of the closing that one runs on for a part of a window, 4 um, and the wall's friction
/// begins to turn round.)
TEST(PressChain, FrameIsThatOfTheGrains) {
  FrameLaw const law_of_frame{.stiffness = 30e6, .seating = 0.1e-3, .seating_force = 2e3};
  PressFrame frame(law_of_frame);
  double const dt = 1e-6;
  double smallest = 20e-3, error = 0.0, largest = 0.0;
  auto const exact = cycle(law_of_frame);
  std::size_t next = 1;
  for (double t = dt; t < course.time[1] && next < exact.size(); t += dt) {
    double const gap = course.at(t) + frame.deflection();
    smallest = std::min(smallest, gap);
    double const force = bed_forces(law, bed, gap, smallest).upper;
    frame.step_done(force, gap, dt);
    if (std::abs(t - exact[next].time) > 0.5 * dt)
      continue;
    error = std::max(error, std::abs(force - exact[next].forces.upper));
    largest = std::max(largest, force);
    ++next;
  }
  EXPECT_GT(next, 120u);
  EXPECT_LT(error, 0.01 * largest);
}

TEST(PressChain, LoadCellShowsTheForceThroughItsErrors) {
  LoadCellErrors const errors{.gain = 0.97, .offset = 20.0, .drift = 300.0};
  for (auto const& r : cycle({}, errors))
    EXPECT_NEAR(r.load_cell, 0.97 * r.forces.upper + 20.0 + 300.0 * r.time, 1e-8);
  // A lag shifts the rise by its time constant once it has settled.
  auto const late = cycle({}, {.lag = 1e-3}), prompt = cycle();
  auto const time_of = [&](auto const& readings) {
    for (auto const& r : readings)
      if (r.load_cell > 0.5 * peak(prompt))
        return r.time;
    return 0.0;
  };
  EXPECT_NEAR(time_of(late) - time_of(prompt), 1e-3, 0.6e-3);
}

TEST(PressChain, EveryNumberOfTheBedCounts) {
  auto const base = cycle();
  std::vector<std::function<void(BedLaw&)>> const turns{[](BedLaw& l) { l.stiffness *= 1.01; },
                                                        [](BedLaw& l) { l.cohesion *= 1.1; },
                                                        [](BedLaw& l) { l.onset += 0.002; },
                                                        [](BedLaw& l) { l.exponent += 0.01; },
                                                        [](BedLaw& l) { l.recovery += 0.01; },
                                                        [](BedLaw& l) { l.opening += 0.05; },
                                                        [](BedLaw& l) { l.wall_friction += 0.01; },
                                                        [](BedLaw& l) { l.radial_ratio += 0.01; },
                                                        [](BedLaw& l) { l.reversal *= 2.0; },
                                                        [](BedLaw& l) {
                                                          l.onset_fill = {0.005, 5e6};
                                                        },
                                                        [](BedLaw& l) {
                                                          l.onset_crush = {0.005, 20e6, 2.0};
                                                        },
                                                        [](BedLaw& l) {
                                                          l.stiffening = {1.0, 3.0};
                                                        },
                                                        [](BedLaw& l) {
                                                          l.yielding = {0.3, 10e6};
                                                        }};
  for (std::size_t k = 0; k < turns.size(); ++k) {
    BedLaw turned = law;
    turns[k](turned);
    auto const other = cycle({}, {}, turned);
    double change = 0.0;
    for (std::size_t i = 0; i < base.size(); ++i)
      change =
          std::max({change, std::abs(other[i].forces.upper - base[i].forces.upper) / peak(base),
                    std::abs(other[i].forces.radial_pressure - base[i].forces.radial_pressure) /
                        bed_forces(law, bed, 8e-3, 8e-3).radial_pressure});
    EXPECT_GT(change, 1e-3) << k;
    EXPECT_LT(change, 0.5) << k;
  }
}

TEST(PressChain, RefusesWhatMakesNoPress) {
  auto const message = [](auto&& act) -> std::string {
    try {
      act();
    } catch (dem::InvalidInput const& error) {
      return error.what();
    }
    return "accepted";
  };
  BedLaw percent = law;
  percent.onset = 60.0;
  EXPECT_EQ(message([&] { cycle({}, {}, percent); }),
            "bed law: onset = 60: is no solid fraction (0 to 1). Is it in percent?");
  EXPECT_EQ(
      message([] { press_course(20e-3, 8e-3, -0.2, 0.2); }),
      "press course: from 0.02 to 0.008 m at -0.2 and 0.2 m/s with a dwell of 0 s. Are speeds "
      "positive, and the fill height above the end gap?");
  EXPECT_EQ(message([] {
              press_cycle({.law = law, .bed = bed}, {.frame = {.gap_offset = -9e-3}}, course,
                          {0.06});
            }),
            "gap course: the faces meet at 0.06 s. Is the gap offset (-0.009 m) right?");
  EXPECT_EQ(message([] {
              press_cycle({.law = law, .bed = bed}, {}, course, {0.1, 0.1});
            }),
            "samples: times do not increase. Are two swapped?");
}
