#include "dem/measure/shape.hpp"

#include "tests/unit/dem/measure_builders.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace dem {
namespace {

/// Fine grains (0.5 mm, simple cubic) wherever `inside(r, z)`, z from the floor.
template <class Inside> Spheres heap(Inside&& inside) {
  return test::simple_cubic(0.5e-3, 60, 30, Vec3(0, 0, 0.25e-3), [&](Vec3 const& x) {
    return inside(x.head<2>().norm() + 0.25e-3, x[2] + 0.2499e-3);
  });
}

auto cylinder(double radius, double height) {
  return heap([=](double r, double z) { return r <= radius && z <= height; });
}

double similarity(Spheres const& a, Spheres const& b) {
  return shape_similarity(compact_shape(a, 0.0), compact_shape(b, 0.0));
}

// A grain of R 3 mm on the axis, centre at 3 mm: the slab from k to k + 1 mm sees the section
// nearest to the centre, at 3 - (k + 1) mm below it or k - 3 mm above it, sqrt(9 - distance^2) mm;
// slabs from 6 mm up are empty.
TEST(CompactShape, OfAGrainOnTheAxisIsItsSections) {
  Spheres grains;
  grains.add({0, 0, 3e-3}, 3e-3, 3000.0, 0);
  auto const shape = compact_shape(grains, 0.0);
  ASSERT_EQ(shape.size(), 16u);
  EXPECT_NEAR(shape[0], 6e-3, 1e-17);
  for (int level = 0; level < 15; ++level) {
    double const off = level < 3 ? 2.0 - level : level - 3.0;
    double const expected = level < 6 ? 1e-3 * std::sqrt(9.0 - off * off) : 0.0;
    EXPECT_NEAR(shape[level + 1], expected, 1e-15) << level;
  }
}

// A small grain away from the axis fills one of 36 sectors (its middle is at 5 degrees): the
// level's mean is (5 + s)/36.
TEST(CompactShape, AveragesTheMaximaOverSectors) {
  Spheres grains;
  double const angle = 5.0 * pi / 180.0;
  grains.add({5e-3 * std::cos(angle), 5e-3 * std::sin(angle), 0.5e-3}, 0.2e-3, 3000.0, 0);
  EXPECT_NEAR(compact_shape(grains, 0.0)[1], 5.2e-3 / 36.0, 1e-12);
  // Nearer to the axis it hides one behind it, and one farther out counts alone.
  grains.add({3e-3 * std::cos(angle), 3e-3 * std::sin(angle), 0.5e-3}, 0.2e-3, 3000.0, 0);
  EXPECT_NEAR(compact_shape(grains, 0.0)[1], 5.2e-3 / 36.0, 1e-12);
}

// A grain over the axis, off by less than its radius, reaches into every sector: straight ahead 1.5
// + 2, behind 2 - 1.5 mm and more; the mean lies strictly between.
TEST(CompactShape, LetsAGrainOverTheAxisReachAllSectors) {
  Spheres grains;
  grains.add({1.5e-3, 0, 0.5e-3}, 2e-3, 3000.0, 0);
  double const mean = compact_shape(grains, 0.0)[1];
  EXPECT_GT(mean, 1.5e-3);
  EXPECT_LT(mean, 2.2e-3);
}

TEST(CompactShape, DoesNotSeeGrainsBelowTheFloorAndFollowsTheFloor) {
  Spheres grains;
  grains.add({0, 0, 8e-3}, 2.9e-3, 3000.0, 0);
  grains.add({9e-3, 0, 4.4e-3}, 1.5e-3, 3000.0, 0);
  Spheres alone;
  alone.add({0, 0, 3e-3}, 2.9e-3, 3000.0, 0);
  auto const high = compact_shape(grains, 5e-3), low = compact_shape(alone, 0.0);
  for (std::size_t k = 0; k < high.size(); ++k)
    EXPECT_NEAR(high[k], low[k], 1e-15);
}

TEST(ShapeSimilarity, OfEqualShapesIsOneAndOfDisjointOnesZero) {
  std::vector<double> const a{1, 2, 0}, b{0, 0, 3};
  EXPECT_DOUBLE_EQ(shape_similarity(a, a), 1.0);
  EXPECT_EQ(shape_similarity(a, b), 0.0);
  EXPECT_DOUBLE_EQ(shape_similarity(b, b), 1.0);
  // b = 2a: 2 / (1 + 4 - 2)
  EXPECT_DOUBLE_EQ(shape_similarity(std::vector<double>{3}, std::vector<double>{6}), 2.0 / 3.0);
  EXPECT_EQ(shape_similarity(std::vector<double>{0}, std::vector<double>{0}), 1.0);
}

TEST(ShapeSimilarity, OfACompactWithItselfIsOne) {
  auto const compact = cylinder(11.025e-3, 10e-3);
  EXPECT_NEAR(compact_shape(compact, 0.0)[0], 10e-3, 1e-15);
  EXPECT_NEAR(compact_shape(compact, 0.0)[1], 11e-3, 0.15e-3);
  EXPECT_DOUBLE_EQ(similarity(compact, compact), 1.0);
}

// Cylinder (10, 11 x 10 levels) against a flat heap of equal volume, 2 mm high, radius 24.6 mm:
// (2, 24.6 x 2 levels). aa = 1310, bb = 1214, ab = 561: 561 / (1310 + 1214 - 561) = 0.286.
TEST(ShapeSimilarity, OfACollapsedHeapIsBelowOneHalf) {
  double const result = similarity(cylinder(11.025e-3, 10e-3), cylinder(24.65e-3, 2e-3));
  EXPECT_NEAR(result, 0.286, 0.01);
  EXPECT_EQ(shape_quality(result), 1);
}

// In units of 1 mm: (10, 11 x 10 levels) against radii 5 % larger, and against one level less.
TEST(ShapeSimilarity, ReactsToALostLevelMoreThanToSwelling) {
  auto const compact = cylinder(11.025e-3, 10e-3);
  double const swollen = similarity(compact, cylinder(11.575e-3, 10e-3));
  double const lower = similarity(compact, cylinder(11.025e-3, 9e-3));
  EXPECT_NEAR(swollen, 0.9975, 0.001); // 1.05 / (1 + 1.1025 - 1.05) = 0.9976 of the levels
  EXPECT_NEAR(lower, 0.906, 0.005);    // (90 + 1089) / (1310 + 1170 - 1179) = 0.906
}

TEST(ShapeQuality, FollowsTheScaleOfTheSeed) {
  EXPECT_EQ(shape_quality(1.0), 5);
  EXPECT_EQ(shape_quality(0.875), 5);
  EXPECT_EQ(shape_quality(0.8749), 4);
  EXPECT_EQ(shape_quality(0.75), 4);
  EXPECT_EQ(shape_quality(0.7499), 3);
  EXPECT_EQ(shape_quality(0.625), 3);
  EXPECT_EQ(shape_quality(0.6249), 2);
  EXPECT_EQ(shape_quality(0.5), 2);
  EXPECT_EQ(shape_quality(0.4999), 1);
  EXPECT_EQ(shape_quality(0.0), 1);
}

} // namespace
} // namespace dem
