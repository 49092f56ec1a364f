#include "coupling/reduced/bed_law.hpp"
#include "dem/expect.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace coupling::reduced;

namespace {

double const pi = std::acos(-1.0);
double const area = 0.25 * pi * 22e-3 * 22e-3; // [m^2]

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
double const h_m = 8e-3; // phi_m = 0.875

BedForces forces(BedLaw const& of, double opened) {
  return bed_forces(of, bed, h_m + opened, h_m);
}

/// s at x = 0.2: 400e6 * 0.2^1.6 - 15e6 * 0.2
double const s_02 = 400e6 * std::pow(0.2, 1.6) - 3e6; // 27.45e6 Pa

std::string message(BedLaw const& of) {
  try {
    validate(of);
  } catch (dem::InvalidInput const& error) {
    return error.what();
  }
  return "accepted";
}

} // namespace

TEST(Table, GoesThroughItsKnotsAndStaysBetweenThem) {
  Table const table{{0.0, 1.0, 2.0, 4.0}, {0.0, 1.0, 1.1, 3.0}};
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_DOUBLE_EQ(table.at(table.knots[k]), table.values[k]);
  EXPECT_EQ(table.at(-1.0), 0.0);
  EXPECT_EQ(table.at(9.0), 3.0);
  double last = 0.0;
  for (double x = 0.0; x <= 4.0; x += 0.01) {
    EXPECT_GE(table.at(x), last);
    last = table.at(x);
  }
  Table const turn{{0.0, 1.0, 2.0}, {0.0, 1.0, 0.0}}; // no slope where it turns
  EXPECT_NEAR(turn.at(1.001), 1.0, 1e-5);
  EXPECT_LE(turn.at(0.999), 1.0);
}

/// Slopes at inner knots by hand: knots 0, 1, 3, secants 1 and 2, w = (1 + 2*2, 2*1 + 2) = (5, 4),
/// slope = 9 / (5/1 + 4/2) = 9/7. In [0, 1]: v = t + t^2 (3 - 2 - 9/7) + t^3 (1 + 9/7 - 2).
TEST(Table, IsFritschAndButlandsCubic) {
  Table const table{{0.0, 1.0, 3.0}, {0.0, 1.0, 5.0}};
  EXPECT_NEAR(table.at(0.5), 0.5 + 0.25 * (1.0 - 9.0 / 7.0) + 0.125 * (9.0 / 7.0 - 1.0), 1e-12);
  EXPECT_NEAR((table.at(1.0 + 1e-6) - table.at(1.0 - 1e-6)) / 2e-6, 9.0 / 7.0, 1e-5);
}

TEST(BedLaw, LoadsAndUnloadsAsWritten) {
  double const phi = 0.8, most = 0.85;
  EXPECT_NEAR(law.loading(phi), s_02, 1.0); // [Pa] of 27e6
  EXPECT_EQ(law.loading(0.59), 0.0);
  double const end = most * std::pow(0.6 / most, 0.7); // phi_u
  double const g = std::log(phi / end) / std::log(most / end);
  EXPECT_NEAR(law.unloading_stress(phi, most), law.loading(most) * std::pow(g, 2.5), 1.0);
  EXPECT_DOUBLE_EQ(law.unloading_stress(most, most), law.loading(most));
  EXPECT_EQ(law.unloading_stress(end - 1e-6, most), 0.0);
}

TEST(BedLaw, WallCarriesItsPartAndTurnsRound) {
  BedForces const closing = forces(law, 0.0);
  double const s = law.loading(0.875), p = 0.45 * s;
  double const wall = 0.2 * p * pi * 22e-3 * h_m; // mu p pi D h
  EXPECT_NEAR(closing.upper, area * s + 0.5 * wall, 1e-9 * closing.upper);
  EXPECT_NEAR(closing.lower, area * s - 0.5 * wall, 1e-9 * closing.upper);
  EXPECT_NEAR(closing.radial_pressure, p, 1e-9 * p);
  BedForces const half = forces(law, 2e-5 * std::log(2.0));
  EXPECT_NEAR(half.upper, half.lower, 1e-9 * half.upper); // t = 0
  // Far on t = -1, and the radial pressure is the root of the stress's share.
  BedForces const opening = forces(law, 0.5e-3);
  double const share = law.unloading_stress(7.0 / 8.5, 0.875) / s;
  EXPECT_NEAR(opening.radial_pressure, p * std::sqrt(share), 1e-9 * p);
  EXPECT_NEAR(opening.upper - opening.lower, -0.2 * p * std::sqrt(share) * pi * 22e-3 * 8.5e-3,
              1e-6 * wall);
}

/// Half round where the length says, that of another pressure, friction or stretch.
TEST(BedLaw, TurnsRoundOverALengthThatGrows) {
  auto const is_half_round = [](BedLaw const& with, double factor) {
    BedForces const half = forces(with, 2e-5 * std::log(2.0) * factor);
    EXPECT_NEAR(half.upper, half.lower, 1e-9 * half.upper) << factor;
  };
  BedLaw with = law;
  with.turn_pressure = 2.0 * 0.45 * law.loading(0.875); // of a turn at twice this pressure
  is_half_round(with, std::pow(0.5, 0.25));
  with = law;
  with.turn_friction = 0.1; // half of what this wall has
  is_half_round(with, 2.0);
  with = law;
  stretch_turn(with, 1.1);
  is_half_round(with, 1.1);
  with.wall_turn = {{0.0, 1e-5, 1e-3}, {1.0, 0.5, -1.0}};
  stretch_turn(with, 2.0);
  EXPECT_EQ(with.wall_turn.knots, (std::vector<double>{0.0, 2e-5, 2e-3}));
}

TEST(BedLaw, HangsOnTheWallRatherThanPull) {
  BedLaw sticky = law;
  sticky.wall_friction = 2.0;
  BedForces const far = forces(sticky, 1.0e-3);
  double const s = law.unloading_stress(7.0 / 9.0, 0.875);
  EXPECT_EQ(far.upper, 0.0);
  EXPECT_NEAR(far.lower, 2.0 * area * s, 1e-9 * far.lower); // mean stress stays s
  EXPECT_GT(s, 1e6);
}

TEST(BedLaw, TablesReplaceTheFormulas) {
  BedLaw with = law;
  with.loading_rest = {{-0.1, 0.1, 0.3}, {0.0, 1e-3, 1e-3}};
  EXPECT_NEAR(with.loading(0.8), s_02 + 400e6 * 1e-3, 1.0);
  EXPECT_NEAR(with.loading(0.6), 400e6 * with.loading_rest.at(0.0), 1.0); // bears before the onset
  with = law;
  with.radial_loading = {{0.0, 0.5}, {1.2, 1.2}};
  with.wall_loading = {{0.0, 0.5}, {0.9, 0.9}};
  auto const plain = forces(law, 0.0), both = forces(with, 0.0);
  EXPECT_NEAR(both.radial_pressure / plain.radial_pressure, 1.2, 1e-12);
  EXPECT_NEAR((both.upper - both.lower) / (plain.upper - plain.lower), 1.2 * 0.9, 1e-9);
  with = law;
  with.unloading = {{0.0, 0.5, 1.0}, {0.0, 0.1, 1.0}};
  with.radial_unloading = {{0.0, 0.5, 1.0}, {0.05, 0.4, 1.0}};
  with.wall_turn = {{0.0, 1e-4, 2e-3}, {1.0, -0.05, -0.05}}; // little: nothing hangs
  double const h = h_m * std::pow(0.875 / 0.6, 0.5 * 0.7);   // g = 0.5
  auto const open = forces(with, h - h_m);
  // The exponent acts on the table, too.
  EXPECT_NEAR(0.5 * (open.upper + open.lower), std::pow(0.1, 2.5) * area * law.loading(0.875),
              1e-3);
  EXPECT_NEAR(open.radial_pressure, 0.4 * plain.radial_pressure, 1e-3);
  EXPECT_NEAR(open.upper - open.lower, -0.05 * 0.2 * open.radial_pressure * pi * 22e-3 * h, 1e-6);
}

TEST(BedLaw, FreeCompactIsWhereNoStressIsLeft) {
  auto const free = free_compact(law, bed, h_m);
  auto const at = [&](double h) { return bed_forces(law, bed, h, h_m); };
  EXPECT_NEAR(at(free.height).upper, free_share * at(h_m).upper, 1e-4 * free_share * at(h_m).upper);
  EXPECT_EQ(free.radial_pressure, at(free.height).radial_pressure);
  EXPECT_LT(free.height, h_m * std::pow(0.875 / 0.6, 0.7)); // where no stress is left at all
  EXPECT_GT(free.height, h_m * std::pow(0.875 / 0.6, 0.5 * 0.7));
  EXPECT_EQ(free_compact(law, bed, 12e-3).height, 12e-3); // never pressed
}

TEST(BedLaw, FreeCompactOfAFitKeepsItsWay) {
  BedLaw with = law;
  with.free_way = 0.1;
  auto const free = free_compact(with, bed, h_m);
  EXPECT_NEAR(free.height, h_m * std::pow(0.875 / 0.6, 0.9 * 0.7), 1e-12);
  EXPECT_NEAR(way_left_at(with, bed, free.height, h_m), 0.1, 1e-12);
  with.wall_friction = 0.02; // hangs less
  EXPECT_EQ(free_compact(with, bed, h_m).height, free.height);
}

/// Each shift by its formula; s0 is the stress that the bed bears there.
TEST(BedLaw, OnsetShiftsWithTheStress) {
  auto const holds = [](BedLaw const& with, double phi, auto const& shift) {
    double const s = with.loading(phi);
    EXPECT_NEAR(with.onset_at(phi), 0.6 + shift(s), 1e-12) << phi;
    EXPECT_NEAR(s, law.loading(phi - shift(s)), 1e-6 * s) << phi;
  };
  BedLaw with = law;
  for (double const phi : {0.62, 0.7, 0.8}) {
    with.onset_fill = {0.01, 20e6};
    holds(with, phi, [](double s) { return -0.01 * std::exp(-s / 20e6); });
    with.onset_fill.tail = 0.5;
    holds(with, phi, [](double s) { return -0.01 * std::pow(1.0 + 0.5 * s / 20e6, -2.0); });
    with = law;
    with.onset_fines = {0.01, 0.3, 40e6};
    holds(with, phi, [](double s) { return -0.01 * (1.0 - 0.3 * s / (s + 40e6)); });
    with = law;
    with.onset_crush = {0.02, 30e6, 2.0};
    holds(with, phi, [](double s) { return 0.02 * -std::expm1(-std::pow(s / 30e6, 2.0)); });
    with = law;
  }
  with.onset_fill = {0.01, 20e6};
  EXPECT_NEAR(with.onset_at(0.5), 0.59, 1e-12); // nothing bears
  with.onset_fines.size = 0.02;
  EXPECT_NEAR(with.onset_at(0.5), 0.57, 1e-12);
  with.onset_fill.size = 0.0, with.onset_fines.size = -0.02; // too many fines
  holds(with, 0.8, [](double) { return 0.02; });
}

TEST(BedLaw, StiffensAndYields) {
  BedLaw with = law;
  with.stiffening = {5.0, 2.0};
  EXPECT_NEAR(with.loading(0.8), 1.2 * (s_02 + 3e6) - 3e6, 1.0); // 1 + 5 * 0.2^2
  with = law;
  with.yielding = {0.5, 10e6};
  double const e = s_02 - 10e6;
  EXPECT_NEAR(with.loading(0.8), s_02 - 0.5 * e * e / (e + 10e6), 1.0);
  EXPECT_DOUBLE_EQ(with.loading(0.65), law.loading(0.65)); // 2.6e6 Pa: nothing yields
}

TEST(BedLaw, RefusesWhatMakesNoBed) {
  EXPECT_EQ(message(law), "accepted");
  BedLaw wrong = law;
  wrong.onset = 60.0;
  EXPECT_EQ(message(wrong),
            "bed law: onset = 60: is no solid fraction (0 to 1). Is it in percent?");
  wrong = law;
  wrong.wall_turn = {{0.0, 0.0}, {1.0, 0.0}};
  EXPECT_EQ(message(wrong), "table wall_turn: knots do not increase. Are two swapped?");
  wrong = law;
  wrong.unloading = {{0.0, 1.0}, {0.0, 27e6}};
  EXPECT_EQ(message(wrong), "table unloading: does not run from a share of 0 to 1 at 1. Is it not "
                            "a share of the largest stress?");
  wrong = law;
  wrong.loading_rest = {{0.0, 1.0}, {1.0, 1.0}};
  EXPECT_EQ(message(wrong), "table loading_rest: does not begin at 0 (a bed that is far apart "
                            "bears nothing). Is it a factor instead?");
  wrong = law;
  wrong.yielding = {2.0, 10e6};
  EXPECT_EQ(message(wrong),
            "bed law: yielding.size = 2: must be at most 1. No more than all is lost?");
}
