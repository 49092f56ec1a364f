// Laboratory tests on one point.
#include "continuum/errors.hpp"
#include "continuum/powder/avicel_ph102.hpp"
#include "continuum/powder/loading_path.hpp"
#include "tests/support/near.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace continuum;

ModifiedCamClay clay() {
  return {.slope = 1.2,
          .initial_relative_density = 0.4,
          .elasticity =
              PressureElasticity{.reference_pressure = 1e5, .kappa = 0.01, .shear_modulus = 2e7},
          .hardening = IndexHardening{.preconsolidation = 2e5, .lambda = 0.05, .kappa = 0.01}};
}

// Beyond p_c the virgin line: p = p_c0 exp[(eps_v - kappa ln(p_c0/p_0))/lambda].
TEST(LoadingPath, IsotropicCompressionFollowsTheVirginLine) {
  PowderPoint point;
  auto const path = compress_isotropically(clay(), point, std::exp(-0.1), 20);
  double const to_yield = 0.01 * std::log(2.0);
  EXPECT_TRUE(near::relative(path.pressure.back(), 2e5 * std::exp((0.1 - to_yield) / 0.05), 1e-9));
  EXPECT_NEAR(path.deviator.back(), 0.0, 1e-4);
  EXPECT_NEAR(path.stress_ratio.back(), 1.0, 1e-12);
  // Work is the integral of p J d eps_v^p; here p is the virgin line's, eps_v^p = ln(p/p_c0) 0.04.
  EXPECT_GT(path.plastic_work.back(), 0.0);
}

TEST(LoadingPath, TriaxialCompressionEndsAtTheCriticalState) {
  PowderPoint point;
  PowderLaw const law = clay();
  auto const isotropic = compress_isotropically(law, point, std::exp(-0.08), 20);
  auto const path = compress_triaxially(law, point, 1.0, 400);
  double const radial = isotropic.pressure.back();
  for (double const stress : path.radial_stress)
    EXPECT_TRUE(near::relative(stress, radial, 1e-9));
  // Drained: q = 3 (p - s_r) all along, and q = M p where the volume no longer changes.
  EXPECT_TRUE(near::relative(path.deviator.back(), 3.0 * (path.pressure.back() - radial), 1e-8));
  EXPECT_NEAR(path.deviator.back() / path.pressure.back(), 1.2, 2e-3);
  EXPECT_NEAR(path.pressure.back(), radial * 3.0 / (3.0 - 1.2), 2e-3 * radial);
}

TEST(LoadingPath, SimpleShearAtConstantVolumeEndsAtTheCriticalState) {
  PowderPoint point;
  PowderLaw const law = clay();
  compress_isotropically(law, point, std::exp(-0.08), 20);
  double const J = point.volume_ratio();
  auto const path = shear_simply(law, point, 0.2, 200);
  EXPECT_NEAR(point.volume_ratio(), J, 1e-13);
  EXPECT_NEAR(path.deviator.back() / path.pressure.back(), 1.2, 2e-3);
  EXPECT_GT(path.shear_stress.back(), 0.0);
  // Undrained strength of Cam-Clay, normally consolidated: p_f = p_c 2^(-(1 - kappa/lambda)).
  EXPECT_TRUE(near::relative(path.pressure.back(), path.pressure[0] * std::pow(2.0, -0.8), 5e-3));
}

TEST(LoadingPath, PressesToAStressAsToItsHeight) {
  PowderLaw const law = avicel_ph102(HardeningReading::consistent);
  PowderPoint by_height, by_stress;
  auto const first = press_to_height(law, by_height, 0.5, 400);
  auto const second = press_to_stress(law, by_stress, first.axial_stress.back(), 400);
  EXPECT_NEAR(second.height_ratio.back(), 0.5, 2e-5);
  EXPECT_TRUE(near::relative(second.axial_stress.back(), first.axial_stress.back(), 1e-9));
}

// Work of the punch is that on plastic and that on elastic strain. The latter is NEGATIVE here:
// total elastic strain falls while the powder stiffens, so plastic work exceeds the punch's by 2.4
// %.
TEST(LoadingPath, PunchWorkIsElasticAndPlastic) {
  PowderLaw const law = avicel_ph102(HardeningReading::consistent);
  PowderPoint point;
  double punch = 0.0, elastic = 0.0;
  Eigen::Vector3d strain = Eigen::Vector3d::Zero();
  constexpr int n = 4400;
  for (int i = 1; i <= n; ++i) {
    Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
    F(2, 2) = 1.0 - 0.55 * i / n;
    double const before = point.deformation(2, 2);
    auto const step = advance(law, point, F);
    Eigen::Vector3d const now = 0.5 * step->point.elastic_left_stretch.diagonal().array().log();
    punch += step->kirchhoff(2, 2) * std::log(F(2, 2) / before);
    elastic += step->kirchhoff.diagonal().dot(now - strain);
    strain = now;
    point = step->point;
  }
  EXPECT_TRUE(near::relative(point.plastic_work + elastic, punch, 1e-9));
  EXPECT_LT(elastic, 0.0);
  EXPECT_NEAR(point.plastic_work / punch, 1.0224, 5e-4);
}

TEST(LoadingPath, JoinsRows) {
  PowderLaw const law = avicel_ph102(HardeningReading::consistent);
  PowderPoint point;
  auto path = press_to_height(law, point, 0.8, 20);
  path.append(press_to_stress(law, point, 0.0, 5));
  EXPECT_EQ(path.size(), 26U);
  EXPECT_EQ(path.plastic_work.size(), 26U);
  EXPECT_EQ(path.surface.size(), 26U);
  EXPECT_NEAR(path.axial_stress.back(), 0.0, 1.0);
}

TEST(LoadingPath, RefusesAStressBeyondTheStrength) {
  PowderLaw const law = avicel_ph102(HardeningReading::consistent);
  PowderPoint point;
  press_to_height(law, point, 0.8, 20);
  EXPECT_THROW(press_to_stress(law, point, -50e6, 2), SolverFailure);
}

} // namespace
