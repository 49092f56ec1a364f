#include "dem/measure/compact.hpp"

#include "dem/measure/contact_statistics.hpp"
#include "dem/measure/energy.hpp"
#include "tests/unit/dem/measure_builders.hpp"

#include <gtest/gtest.h>

namespace dem {
namespace {

using test::touch;
using test::touch_tool;

// One grain of R 1 mm in a bore of 2 mm: h = 2 mm, P = 1 - (4/3 R^3) / (r^2 h) = 1 - (4/3) / 8 =
// 5/6.
TEST(SeedPorosity, IsThatOfASphereInItsCylinder) {
  Spheres grains;
  grains.add({0.5e-3, 0.0, 1.2e-3}, 1e-3, 3000.0, 0);
  auto const result = seed_porosity(grains, {}, 2e-3, 0.0);
  EXPECT_NEAR(result.height, 2e-3, 1e-18);
  EXPECT_NEAR(result.porosity, 5.0 / 6.0, 1e-14);
  EXPECT_EQ(result.n_grains, 1u);
}

// Two grains of R overlap by R/5: the lens is two caps of height R/10, 2 pi (R/10)^2 (3R - R/10)/3
// = 0.0193333.. pi R^3.
TEST(SeedPorosity, SubtractsTheLensOnce) {
  double const R = 1e-3;
  Spheres grains;
  grains.add({0.0, 0.0, R}, R, 3000.0, 0);
  grains.add({0.0, 0.0, 2.8 * R}, R, 3000.0, 0);
  std::vector<Contact> const contacts{touch(grains, 0, 1, Vec3(0, 0, -1)),
                                      touch_tool(grains, 0, Vec3(0, 0, 0.1e-3), Vec3(0, 0, 1))};
  double const lens = 2.0 * 0.01 * 2.9 / 3.0 * pi * R * R * R;
  auto const result = seed_porosity(grains, contacts, 2.0 * R, 0.0);
  EXPECT_NEAR(result.solid_volume, 8.0 / 3.0 * pi * R * R * R - lens, 1e-12 * lens);
  EXPECT_NEAR(result.porosity, 1.0 - (8.0 / 3.0 - lens / (pi * R * R * R)) / (4.0 * 3.8), 1e-14);
}

TEST(SeedPorosity, LeavesOutGrainsThatFellBelowThePunchFace) {
  Spheres grains;
  grains.add({0.0, 0.0, 1e-3}, 1e-3, 3000.0, 0);
  grains.add({0.0, 0.0, -0.5e-3}, 1e-3, 3000.0, 0);
  std::vector<Contact> const contacts{touch(grains, 0, 1, Vec3::Zero())};
  auto const result = seed_porosity(grains, contacts, 2e-3, 0.0);
  EXPECT_EQ(result.n_grains, 1u);
  EXPECT_NEAR(result.porosity, 5.0 / 6.0, 1e-14);
  EXPECT_EQ(seed_porosity(grains, contacts, 2e-3, 5e-3).porosity, 1.0);
  EXPECT_EQ(seed_porosity({}, {}, 2e-3, 0.0).height, 0.0);
}

// 2000 grains with tops at 1, 2, ... 2000 um above their own depth: rank ceil(0.999 2000) = 1998.
// The lowest surface is that of the first grain, its top at 1 um minus 2 R.
TEST(SeedPorosity, RanksTheTopsSoThatThrownGrainsDoNotCount) {
  Spheres grains;
  double const R = 0.1e-6;
  for (int k = 1; k <= 2000; ++k)
    grains.add({0.0, 0.0, k * 1e-6 - R}, R, 3000.0, 0);
  EXPECT_NEAR(ranked_height(grains, 0.0), 1997e-6 + 2.0 * R, 1e-15);
  EXPECT_NEAR(ranked_height(grains, 0.0, 0.99), 1979e-6 + 2.0 * R, 1e-15);
  EXPECT_NEAR(ranked_height(grains, 0.0, 1.0), compact_extent(grains, 0.0).height(), 1e-18);
}

// A row of three grains, radii 1, 1 and 2 mm, overlaps 0.1 and 0.2 mm, the first in a tool by 0.3
// mm; a fourth lies apart.
TEST(ContactStatistics, CountOverlapsGrainsAndRattlers) {
  Spheres grains;
  grains.add({0.0, 0.0, 0.0}, 1e-3, 3000.0, 0);
  grains.add({1.9e-3, 0.0, 0.0}, 1e-3, 3000.0, 0);
  grains.add({4.7e-3, 0.0, 0.0}, 2e-3, 3000.0, 0);
  grains.add({9.0e-3, 0.0, 0.0}, 1e-3, 3000.0, 0);
  std::vector<Contact> const contacts{
      touch(grains, 0, 1, Vec3::Zero()), touch_tool(grains, 0, Vec3(-0.7e-3, 0, 0), Vec3::Zero()),
      touch(grains, 1, 2, Vec3::Zero()),
      touch(grains, 2, 3, Vec3::Zero())}; // a gap within a law's reach: no contact
  auto const result = measure_contacts(grains, contacts);
  EXPECT_EQ(result.n_grain_contacts, 2u);
  EXPECT_EQ(result.n_tool_contacts, 1u);
  EXPECT_NEAR(result.mean_overlap, 0.15e-3, 1e-17);
  EXPECT_NEAR(result.max_overlap, 0.2e-3, 1e-17);
  EXPECT_NEAR(result.max_relative_overlap, 0.2, 1e-12); // 0.2 mm in the smaller radius 1 mm
  EXPECT_NEAR(result.max_relative_tool_overlap, 0.3, 1e-12);
  EXPECT_DOUBLE_EQ(result.coordination, 1.0);  // 2 contacts, 4 grains
  EXPECT_DOUBLE_EQ(result.rattler_share, 0.5); // the third has one contact, the fourth none
  EXPECT_DOUBLE_EQ(result.mechanical_coordination, 1.0); // the first two share one
}

TEST(ContactStatistics, AreZeroAndNeverNanWithoutContacts) {
  auto const none = measure_contacts({}, {});
  EXPECT_EQ(none.mean_overlap, 0.0);
  EXPECT_EQ(none.coordination, 0.0);
  EXPECT_EQ(none.mechanical_coordination, 0.0);
  EXPECT_EQ(none.rattler_share, 0.0);
}

// m = 3000 4/3 pi 1e-9 = 4 pi 1e-6 kg; v = 5 m/s: 12.5 m; w = 2000 rad/s: 1/2 2/5 m R^2 w^2 = 0.8
// m; m g z = 9.81 0.02 m.
TEST(Energy, SumsTranslationRotationAndHeight) {
  Spheres grains;
  grains.add({1e-3, 0.0, 0.02}, 1e-3, 3000.0, 0, Vec3(3, 0, 4), Vec3(0, 2000, 0));
  grains.add({0.0, 0.0, 0.0}, 1e-3, 3000.0, 0);
  double const m = 4.0 * pi * 1e-6;
  EXPECT_NEAR(kinetic_energy(grains).translation, 12.5 * m, 1e-18);
  EXPECT_NEAR(kinetic_energy(grains).rotation, 0.8 * m, 1e-18);
  EXPECT_NEAR(kinetic_energy(grains).total(), 13.3 * m, 1e-18);
  EXPECT_NEAR(gravity_energy(grains, Vec3(0, 0, -9.81)), 0.1962 * m, 1e-18);
  EXPECT_NEAR(momentum(grains)[2], 4.0 * m, 1e-18);
}

} // namespace
} // namespace dem
