#include "dem/measure/core.hpp"

#include "dem/measure/quadrature.hpp"
#include "tests/unit/dem/measure_builders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace dem {
namespace {

using test::keep_all;
using test::simple_cubic;

constexpr CoreRegion unbounded(double radius) {
  return {.radius = radius, .bottom = -10.0, .top = 10.0};
}

// Exact to degree 2n - 1: the integral of x^(2n-2) over -1 .. 1 is 2/(2n - 1), that of any odd
// power 0.
TEST(Quadrature, IsExactToItsDegree) {
  for (int n : {1, 2, 5, 12}) {
    auto const rule = gauss_legendre(n);
    double even = 0.0, odd = 0.0;
    for (std::size_t k = 0; k < rule.points.size(); ++k) {
      even += rule.weights[k] * std::pow(rule.points[k], 2 * n - 2);
      odd += rule.weights[k] * std::pow(rule.points[k], 2 * n - 1);
    }
    EXPECT_NEAR(even, 2.0 / (2 * n - 1), 1e-14);
    EXPECT_NEAR(odd, 0.0, 1e-14);
  }
}

// Two unit circles through each other's centres: 2 pi/3 - sqrt(3)/2.
TEST(Core, CircleOverlapIsTheVesicaPiscis) {
  EXPECT_NEAR(circle_overlap_area(1.0, 1.0, 1.0), 2.0 * pi / 3.0 - std::sqrt(3.0) / 2.0, 1e-15);
  EXPECT_NEAR(circle_overlap_area(1.0, 3.0, 1.5), pi, 1e-15);
  EXPECT_EQ(circle_overlap_area(1.0, 3.0, 4.0), 0.0);
}

TEST(Core, CutsSpheresByPlanesExactly) {
  // A cap of height 1/2 of the unit sphere: pi h^2 (3 - h)/3 = 5 pi/24.
  EXPECT_NEAR(volume_in_core(Vec3(1, 1, 0), 1.0, {.radius = 9.0, .bottom = 0.5, .top = 5.0}),
              5.0 * pi / 24.0, 1e-14);
  EXPECT_NEAR(volume_in_core(Vec3(1, 1, 0), 1.0, {.radius = 9.0, .bottom = -5.0, .top = 0.0}),
              2.0 * pi / 3.0, 1e-14);
  EXPECT_EQ(volume_in_core(Vec3(1, 1, 0), 1.0, {.radius = 9.0, .bottom = 1.0, .top = 5.0}), 0.0);
  EXPECT_EQ(volume_in_core(Vec3(6, 8, 0), 1.0, unbounded(9.0)), 0.0);
}

// Sphere of radius 1: a cylinder of radius a on its axis takes 4 pi/3 (1 - (1 - a^2)^(3/2)); one of
// radius 1/2 through its centre and its equator takes Viviani's 2/3 (pi - 4/3).
TEST(Core, CutsSpheresByTheCylinderToOneInTenThousand) {
  double const napkin = 4.0 / 3.0 * pi * (1.0 - std::pow(1.0 - 0.36, 1.5));
  EXPECT_NEAR(volume_in_core(Vec3::Zero(), 1.0, unbounded(0.6)), napkin, 1e-4 * napkin);
  double const viviani = 2.0 / 3.0 * (pi - 4.0 / 3.0);
  EXPECT_NEAR(volume_in_core(Vec3(0.3, 0.4, 0), 1.0, unbounded(0.5)), viviani, 1e-4 * viviani);
}

// Sums over columns of side 0.002 of the chord that the unit sphere and a plane leave of each.
// Columns on the core's rim, at most 2/0.002 = 1000, are wrong by 0.3 of 0.002^2 times a chord
// below 2 at random: 4 sqrt(1000) 2.4e-6 = 3e-4.
TEST(Core, AgreesWithAPlainSumOverColumns) {
  CoreRegion const core{.radius = 2.0, .bottom = -0.4, .top = 9.0};
  constexpr double side = 0.002;
  for (double offset : {1.3, 1.8, 2.2, 2.7}) {
    double sum = 0.0;
    for (int j = 0; j < 1000; ++j)
      for (int i = 0; i < 1000; ++i) {
        double const x = (i + 0.5) * side - 1.0, y = (j + 0.5) * side - 1.0;
        if (x * x + y * y > 1.0 || std::hypot(x + offset, y) > core.radius)
          continue;
        double const half_chord = std::sqrt(1.0 - x * x - y * y);
        sum += side * side * (half_chord - std::max(core.bottom, -half_chord));
      }
    EXPECT_NEAR(volume_in_core(Vec3(offset, 0, 0), 1.0, core), sum, 3e-4) << offset;
  }
}

// Simple cubic: 1 - pi/6 = 0.4764. A circle of 10 d cuts lattice cells at random; over eight places
// of the axis its mean keeps within 2e-3.
TEST(Core, PorosityOfSimpleCubicIsOneMinusPiOverSix) {
  double const d = 0.5e-3;
  double mean = 0.0;
  for (int place = 0; place < 8; ++place) {
    Vec3 const shift(0.13 * place * d, 0.29 * place * d, 0.5 * d);
    auto const grains = simple_cubic(d, 13, 6, shift, keep_all);
    mean += core_porosity(grains, {}, {.radius = 10.0 * d, .bottom = 0.0, .top = 6.0 * d}) / 8.0;
  }
  EXPECT_NEAR(mean, 1.0 - pi / 6.0, 2e-3);
}

// Face-centred cubic: 1 - pi/(3 sqrt 2) = 0.2595, cube edge d sqrt 2; the region's planes cut
// grains in both halves.
TEST(Core, PorosityOfFaceCentredCubicIsThatOfTheDensestPacking) {
  double const d = 0.5e-3, edge = std::sqrt(2.0) * d;
  double mean = 0.0;
  for (int place = 0; place < 8; ++place) {
    Spheres grains;
    Vec3 const shift(0.13 * place * edge, 0.29 * place * edge, 0.1 * d);
    for (Vec3 const& corner :
         std::array<Vec3, 4>{Vec3(0, 0, 0), Vec3(0, .5, .5), Vec3(.5, 0, .5), Vec3(.5, .5, 0)})
      for (int k = -1; k <= 6; ++k)
        for (int j = -10; j <= 10; ++j)
          for (int i = -10; i <= 10; ++i)
            grains.add(shift + edge * (corner + Vec3(i, j, k)), 0.5 * d, 3000.0, 0);
    mean +=
        core_porosity(grains, {}, {.radius = 7.0 * edge, .bottom = 0.0, .top = 5.0 * edge}) / 8.0;
  }
  EXPECT_NEAR(mean, 1.0 - pi / (3.0 * std::sqrt(2.0)), 2e-3);
}

// Two grains of R overlap by R/5 well inside: the lens (see SeedPorosity) is in the core once;
// pressed through the surface, half of it.
TEST(Core, SubtractsTheLensesInside) {
  Spheres grains;
  grains.add({0.0, 0.0, 1.0}, 1.0, 3000.0, 0);
  grains.add({0.0, 0.0, 2.8}, 1.0, 3000.0, 0);
  std::vector<Contact> const contacts{test::touch(grains, 0, 1, Vec3::Zero())};
  double const lens = 2.0 * 0.01 * 2.9 / 3.0 * pi;
  CoreRegion const all{.radius = 2.0, .bottom = -1.0, .top = 5.0};
  EXPECT_NEAR(core_porosity(grains, contacts, all), 1.0 - (8.0 / 3.0 * pi - lens) / (24.0 * pi),
              1e-12);
  CoreRegion const half{.radius = 2.0, .bottom = -1.0, .top = 1.9};
  double const below =
      4.0 / 3.0 * pi - 0.5 * lens; // the upper grain adds the cap that the lower one lost
  EXPECT_NEAR(core_porosity(grains, contacts, half),
              1.0 - (below + 0.5 * lens - 0.5 * lens) / (11.6 * pi), 1e-12);
}

// Every square of side d holds one axis of a simple cubic lattice, so its column reaches the
// topmost surface exactly.
TEST(Core, MeanSurfacesOfALatticeAreItsEnvelope) {
  double const d = 0.5e-3;
  auto const grains = simple_cubic(d, 13, 6, Vec3(0.3 * d, 0.1 * d, 0.5 * d), keep_all);
  CoreRegion const core = find_core(grains, 5e-3, 0.0);
  EXPECT_NEAR(core.bottom, 0.0, 1e-15);
  EXPECT_NEAR(core.top, 6.0 * d, 1e-15);
}

// One thrown grain 5 mm up covers at most 9 of the about 314 columns: the highest surface rises
// by 5.25 mm, the mean by less than 9/300 of it, and by more than one column's part.
TEST(Core, MeanSurfaceHardlySeesAThrownGrain) {
  double const d = 0.5e-3;
  auto grains = simple_cubic(d, 13, 6, Vec3(0.3 * d, 0.1 * d, 0.5 * d), keep_all);
  grains.add({0.0, 0.0, 6.0 * d + 5e-3}, 0.5 * d, 3000.0, 0);
  double const lift = find_core(grains, 5e-3, 0.0).top - 6.0 * d;
  EXPECT_GT(lift, 5.25e-3 / 330.0);
  EXPECT_LT(lift, 5.25e-3 * 9.0 / 300.0);
}

TEST(Core, IsEmptyWithoutGrains) {
  CoreRegion const core = find_core({}, 5e-3, 1e-3);
  EXPECT_EQ(core.top, core.bottom);
  EXPECT_EQ(core_porosity({}, {}, core), 1.0);
}

} // namespace
} // namespace dem
