#include "tests/diagnosis/hide/column.hpp"
#include "tests/diagnosis/hide/press.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace hidden;

constexpr double pi = std::numbers::pi;

Column column(Powder const& powder = {}, Effects const& effects = {}) {
  return {BedLaw(powder, effects), stated_mass, powder.wall_stiffness,
          effects[Effect::die_compliance]};
}

/// Down to 8 mm and up again to 8.3 mm, in `steps`.
Column pressed(Column bed, double up_to = 8.3 * mm) {
  for (double height = 11.5 * mm; height > 8.0 * mm; height -= 0.05 * mm)
    bed.press(height, stated_bore);
  for (double height = 8.0 * mm; height < up_to; height += 0.005 * mm)
    bed.press(height, stated_bore);
  return bed;
}

double solid_volume(Column const& bed) {
  BedLaw const law({}, {});
  double volume = 0.0;
  for (auto const& slice : bed.slices())
    volume += law.solid_fraction(slice.stress, slice.largest, slice.densest) * slice.height * 0.25 *
              pi * stated_bore * stated_bore;
  return volume;
}

// 9.13 g over 1 / (0.8 / 3500 + 0.2 / 3000) = 3387.1 kg/m^3, going down, at the turn, coming up.
TEST(HiddenColumn, KeepsItsMass) {
  double const volume = stated_mass / 3387.0968;
  EXPECT_NEAR(solid_volume(pressed(column(), 8.0 * mm)), volume, 1e-7 * volume);
  EXPECT_NEAR(solid_volume(pressed(column())), volume, 1e-7 * volume);
}

TEST(HiddenColumn, FillsTheGap) {
  auto bed = column();
  bed.press(9.0 * mm, stated_bore);
  double sum = 0.0;
  for (auto const& slice : bed.slices())
    sum += slice.height;
  EXPECT_NEAR(sum, 9.0 * mm, 1e-10);
}

TEST(HiddenColumn, HandsItsForceFromSliceToSlice) {
  auto const bed = pressed(column());
  auto const& slices = bed.slices();
  for (std::size_t i = 0; i < slices.size(); ++i) {
    double const wall = slices[i].shear * pi * stated_bore * slices[i].height;
    EXPECT_NEAR(slices[i].above - slices[i].below, wall, 1e-9 * slices[i].above);
    if (i > 0) {
      EXPECT_EQ(slices[i].above, slices[i - 1].below);
    }
  }
}

// Forces of neighbours on the way down: F_lower / F_upper = exp(-4 mu k H / D), Janssen without
// weight: exp(-4 x 0.205 x 0.51 x 8 / 22.05) = 0.8592.
TEST(HiddenColumn, TransmitsAsJanssenSays) {
  Column bed = column();
  ColumnForces forces;
  for (double height = 11.5 * mm; height > 7.99 * mm; height -= 0.05 * mm)
    forces = bed.press(height, stated_bore);
  EXPECT_NEAR(forces.lower / forces.upper, 0.8592, 0.001);
}

TEST(HiddenColumn, WithoutFrictionLoadsBothPunchesAlike) {
  Powder smooth;
  smooth.wall_friction = 0.0;
  auto const bed = pressed(column(smooth));
  EXPECT_GT(bed.slices().front().above, 1000.0);
  EXPECT_EQ(bed.slices().front().above, bed.slices().back().below);
}

// Next to the moving punch the wall slides back while at the fixed one it still holds the other
// way.
TEST(HiddenColumn, TurnsItsFrictionRoundSliceBySlice) {
  auto const bed = pressed(column(), 8.04 * mm);
  EXPECT_LT(bed.slices().front().shear, 0.0);
  EXPECT_GT(bed.slices().back().shear, 0.0);
}

// Bounds of the full-size DEM runs that the numbers were taken from.
TEST(HiddenPress, ComesDownAsTheGrainsDo) {
  auto const cycle = press_cycle({}, {}, {});
  double peak = 0.0;
  for (auto const& at : cycle.moments)
    peak = std::max(peak, at.upper);
  EXPECT_NEAR(peak, 25.2e3, 0.3e3);
  auto const share_at = [&](double gap) { // on the way up, between the moments
    for (std::size_t k = 1; k < cycle.moments.size(); ++k) {
      auto const &a = cycle.moments[k - 1], &b = cycle.moments[k];
      if (a.gap < gap && b.gap >= gap)
        return (a.upper + (b.upper - a.upper) * (gap - a.gap) / (b.gap - a.gap)) / peak;
    }
    return 0.0;
  };
  EXPECT_NEAR(share_at(8.39 * mm), 0.5, 0.03);
  EXPECT_NEAR(share_at(9.45 * mm), 0.1, 0.015);
  EXPECT_NEAR(share_at(10.42 * mm), 0.01, 0.005);
}

} // namespace
