// The point at finite strain: objectivity, the spatial tangent, and the order of the step.
#include "continuum/powder/avicel_ph102.hpp"
#include "continuum/powder/material_point.hpp"
#include "tests/support/near.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace {

using namespace continuum;

using Matrix = Eigen::Matrix3d;

Matrix rotation(double angle, Eigen::Vector3d const& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

Matrix random_matrix(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Matrix::NullaryExpr([&] { return normal(random); });
}

Matrix diagonal(double a, double b, double c) {
  return Eigen::Vector3d(a, b, c).asDiagonal();
}

PowderPoint pressed(PowderLaw const& law, Matrix const& shape) {
  PowderPoint point;
  for (int i = 1; i <= 20; ++i)
    point =
        advance(law, point, Matrix::Identity() + i / 20.0 * (shape - Matrix::Identity()))->point;
  return point;
}

std::vector<PowderLaw> laws() {
  auto corrected = avicel_ph102(HardeningReading::as_filed);
  corrected.shear_flow = ShearFlow::admissible;
  corrected.transition = 0.03;
  ModifiedCamClay const clay{
      .slope = 1.3,
      .cohesion = 1e5,
      .initial_relative_density = 0.35,
      .elasticity = DensityElasticity{.young_modulus = 2e9, .poisson_ratio = 0.2},
      .hardening = HeckelHardening{
          .initial_pressure = 1e6, .yield_pressure = 30e6, .reference_density = 0.35}};
  return {avicel_ph102(HardeningReading::consistent), corrected, clay};
}

// The same history seen from a turning frame: F*(t) = Q(t) F(t). Stress turns with it, the powder
// does not notice.
TEST(PowderPoint, IsObjective) {
  for (auto const& law : laws()) {
    PowderPoint still, turning;
    Matrix Q = Matrix::Identity();
    for (int i = 1; i <= 30; ++i) {
      Matrix F = diagonal(1.0, 1.0, 1.0 - 0.015 * i);
      F(0, 2) = 0.005 * i;
      Q = rotation(0.2 * i, {1.0, 2.0, -0.5});
      auto const a = advance(law, still, F), b = advance(law, turning, Q * F);
      ASSERT_TRUE(a && b);
      EXPECT_LT((b->cauchy - Q * a->cauchy * Q.transpose()).norm(), 1e-12 * a->cauchy.norm());
      EXPECT_NEAR(b->point.powder.plastic_compaction, a->point.powder.plastic_compaction, 1e-13);
      still = a->point;
      turning = b->point;
    }
    EXPECT_TRUE(near::relative(turning.plastic_work, still.plastic_work, 1e-11));
  }
}

TEST(PowderPoint, DoesNotFeelARigidTurn) {
  for (auto const& law : laws()) {
    PowderPoint const point = pressed(law, diagonal(1.0, 1.0, 0.6));
    Matrix const Q = rotation(1.1, {0.3, -1.0, 0.4});
    auto const turned = advance(law, point, Q * point.deformation);
    ASSERT_TRUE(turned);
    Matrix const expected = Q * cauchy_stress(law, point) * Q.transpose();
    EXPECT_LT((turned->cauchy - expected).norm(), 1e-12 * expected.norm());
    EXPECT_NEAR(turned->point.plastic_work, point.plastic_work, 1e-9 * point.plastic_work);
  }
}

/// Column 3 k + l of the tangent by central differences of tau along L = e_k e_l^T.
SpatialTangent by_differences(PowderLaw const& law, PowderPoint const& from, Matrix const& F,
                              double h) {
  SpatialTangent result;
  for (int k = 0; k < 9; ++k) {
    Matrix L = Matrix::Zero();
    L(k / 3, k % 3) = h;
    Matrix const change =
        (advance(law, from, F + L * F)->kirchhoff - advance(law, from, F - L * F)->kirchhoff) /
        (2.0 * h);
    for (int i = 0; i < 9; ++i)
      result(i, k) = change(i / 3, i % 3);
  }
  return result;
}

TEST(PowderPoint, SpatialTangentIsThatOfDifferences) {
  std::mt19937 random(7);
  for (auto const& law : laws()) {
    PowderPoint const die = pressed(law, diagonal(1.0, 1.0, 0.6));
    for (int i = 0; i < 30; ++i) {
      double const size = i % 3 == 0 ? 1e-4 : 1e-2;
      Matrix const F = (Matrix::Identity() + size * random_matrix(random)) * die.deformation;
      auto const step = advance(law, die, F);
      ASSERT_TRUE(step);
      auto const difference = by_differences(law, die, F, 1e-7);
      EXPECT_LT((step->tangent - difference).norm(), 5e-6 * difference.norm())
          << name_of(step->surface);
    }
  }
}

TEST(PowderPoint, SpatialTangentWithEqualPrincipalValues) {
  for (auto const& law : laws()) {
    PowderPoint const die = pressed(law, diagonal(1.0, 1.0, 0.6));
    PowderPoint const ball = pressed(law, 0.85 * Matrix::Identity());
    auto const check = [&](PowderPoint const& from, Matrix const& F) {
      auto const step = advance(law, from, F);
      ASSERT_TRUE(step);
      auto const difference = by_differences(law, from, F, 1e-7);
      EXPECT_LT((step->tangent - difference).norm(), 5e-6 * difference.norm());
    };
    Matrix const Q = rotation(0.7, {1.0, 1.0, 0.2});
    check(die, diagonal(1.0, 1.0, 0.59));        // two equal, loading
    check(die, Q * diagonal(1.0, 1.0, 0.605));   // two equal, unloading, turned
    check(die, diagonal(1.0, 1.0 + 1e-9, 0.59)); // nearly equal, below the bound
    check(die, diagonal(1.0, 1.0 + 1e-6, 0.59)); // nearly equal, above it
    check(ball, Q * 0.84 * Matrix::Identity());  // three equal
    check(PowderPoint{}, Matrix::Identity());    // and at rest
  }
}

TEST(PowderPoint, TangentTurnsStressWithARigidSpin) {
  auto const law = avicel_ph102(HardeningReading::consistent);
  PowderPoint const die = pressed(law, diagonal(1.0, 1.0, 0.6));
  auto const step = advance(law, die, die.deformation);
  Matrix spin = Matrix::Zero();
  spin(0, 2) = 1.0;
  spin(2, 0) = -1.0;
  Matrix const expected = spin * step->kirchhoff - step->kirchhoff * spin;
  for (int i = 0; i < 9; ++i) {
    double const change = step->tangent(i, 2) - step->tangent(i, 6);
    EXPECT_NEAR(change, expected(i / 3, i % 3), 1e-9 * step->tangent.norm());
  }
}

// Backward Euler: the error of the stress at the end halves with the step.
TEST(PowderPoint, HalvedStepsConvergeAtFirstOrder) {
  auto const law = laws()[2];
  auto const end = [&](int n) {
    PowderPoint point;
    Matrix stress;
    for (int i = 1; i <= n; ++i) {
      double const t = static_cast<double>(i) / n;
      Matrix F = diagonal(1.0, 1.0 - 0.1 * t * t, 1.0 - 0.45 * t);
      F(0, 2) = 0.2 * t * t;
      auto const step = advance(law, point, F);
      point = step->point;
      stress = step->cauchy;
    }
    return stress;
  };
  Matrix const a = end(50), b = end(100), c = end(200), d = end(400);
  double const first = (a - b).norm(), second = (b - c).norm(), third = (c - d).norm();
  EXPECT_NEAR(std::log2(first / second), 1.0, 0.1);
  EXPECT_NEAR(std::log2(second / third), 1.0, 0.05);
  EXPECT_LT(third, 2e-3 * d.norm());
}

TEST(PowderPoint, TellsWhyAStepHasNoAnswer) {
  auto const law = avicel_ph102(HardeningReading::consistent);
  auto const inverted = advance(law, {}, diagonal(1.0, 1.0, -0.5));
  ASSERT_FALSE(inverted);
  EXPECT_EQ(inverted.failure().reason, PowderFailure::Reason::inverted);
  auto const solid =
      law.respond({.plastic_compaction = std::log(0.99 / 0.3411)}, Eigen::Vector3d::Constant(-0.2));
  ASSERT_FALSE(solid);
  EXPECT_EQ(solid.failure().reason, PowderFailure::Reason::density_above_one);
  EXPECT_NE(solid.failure().message().find("relative density 0.99"), std::string::npos);
}

} // namespace
