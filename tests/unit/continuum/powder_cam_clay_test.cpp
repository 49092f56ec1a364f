// Modified Cam-Clay: the oedometer of powder.md 1.4, and what is known of its stress ratio.
#include "continuum/powder/loading_path.hpp"
#include "tests/support/near.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using namespace continuum;

ModifiedCamClay soil() {
  return {.slope = 1.2,
          .initial_relative_density = 0.5,
          .elasticity =
              PressureElasticity{.reference_pressure = 1e5, .kappa = 0.002, .shear_modulus = 5e7},
          .hardening = IndexHardening{.preconsolidation = 1.5e5, .lambda = 0.003, .kappa = 0.002}};
}

/// A powder in a die whose p_c = (M) goes without bound towards the solid.
ModifiedCamClay powder() {
  return {.slope = 1.3,
          .cohesion = 1e5,
          .initial_relative_density = 0.35,
          .elasticity = DensityElasticity{.young_modulus = 2e9, .poisson_ratio = 0.2},
          .hardening = HeckelHardening{
              .initial_pressure = 1e6, .yield_pressure = 30e6, .reference_density = 0.35}};
}

TEST(PowderCamClay, Oedometer) {
  auto const law = soil();
  PowderPoint point;
  struct {
    double strain, p, q, axial, radial, ratio, p_c;
  } const table[] = {{0.0005, 128.40, 50.00, 161.74, 111.74, 0.691, 150.0},
                     {0.0010, 150.79, 78.71, 203.27, 124.55, 0.613, 179.3},
                     {0.0020, 207.25, 123.11, 289.32, 166.22, 0.575, 258.0},
                     {0.0030, 289.87, 169.33, 402.76, 233.43, 0.580, 358.6},
                     {0.0040, 408.14, 221.53, 555.83, 334.29, 0.601, 491.6},
                     {0.0030, 247.55, 121.53, 328.57, 207.04, 0.630, 491.6},
                     {0.0020, 150.14, 21.53, 164.50, 142.97, 0.869, 491.6}};
  double before = 0.0;
  for (auto const& row : table) {
    auto const path =
        press_to_height(law, point, std::exp(-row.strain), row.strain > before ? 1000 : 3);
    before = row.strain;
    EXPECT_TRUE(near::relative(path.pressure.back() / 1e3, row.p, 1e-3)) << row.strain;
    EXPECT_TRUE(near::relative(path.deviator.back() / 1e3, row.q, 1e-3)) << row.strain;
    EXPECT_TRUE(near::relative(path.axial_stress.back() / 1e3, row.axial, 1e-3)) << row.strain;
    EXPECT_TRUE(near::relative(path.radial_stress.back() / 1e3, row.radial, 1e-3)) << row.strain;
    EXPECT_NEAR(path.stress_ratio.back(), row.ratio, 1e-3);
    EXPECT_TRUE(near::relative(law.consolidation_pressure(point.powder) / 1e3, row.p_c, 1e-3));
  }
}

TEST(PowderCamClay, ElasticLegsAreExact) {
  PowderLaw const law = soil();
  PowderPoint point;
  auto const load = press_to_height(law, point, std::exp(-0.0005), 3);
  // p = p_0 exp(eps/kappa), q = 2 G eps
  EXPECT_TRUE(near::relative(load.pressure.back(), 1e5 * std::exp(0.25), 1e-10));
  EXPECT_TRUE(near::relative(load.deviator.back(), 2.0 * 5e7 * 0.0005, 1e-10));
  press_to_height(law, point, std::exp(-0.004), 100);
  auto const unload = press_to_height(law, point, std::exp(-0.003), 2);
  EXPECT_TRUE(near::relative(unload.pressure.back() / unload.pressure[0], std::exp(-0.5), 1e-10));
  EXPECT_TRUE(
      near::relative(unload.deviator[0] - unload.deviator.back(), 2.0 * 5e7 * 0.001, 1e-10));
}

TEST(PowderCamClay, VirginStressRatios) {
  struct {
    double M, rigid, elastic;
  } const list[] = {{0.8, 0.8235, 0.7962},
                    {1.0, 0.7481, 0.7169},
                    {1.2, 0.6713, 0.6397},
                    {1.4, 0.5966, 0.5671},
                    {1.6, 0.5259, 0.5002}};
  for (auto const& row : list) {
    EXPECT_NEAR(lateral_ratio(virgin_stress_ratio(row.M, 1.0, 0.2)), row.rigid, 5e-5);
    EXPECT_NEAR(lateral_ratio(virgin_stress_ratio(row.M, 0.8, 0.2)), row.elastic, 5e-5);
    double const closed = (std::sqrt(9.0 + 4.0 * row.M * row.M) - 3.0) / 2.0;
    EXPECT_TRUE(near::relative(virgin_stress_ratio(row.M, 1.0, 0.3), closed, 1e-14));
  }
}

// On the virgin line the stress path is straight, dq/dp = eta, if G is that of a constant nu there.
TEST(PowderCamClay, StressPathOnTheVirginLineIsStraight) {
  double const M = 1.2, nu = 0.2, kappa = 0.002, lambda = 0.01, p = 3e5;
  double const eta = virgin_stress_ratio(M, 1.0 - kappa / lambda, nu);
  auto law = soil();
  double const G = 3.0 * (1.0 - 2.0 * nu) / (2.0 * (1.0 + nu)) * p / kappa;
  law.elasticity =
      PressureElasticity{.reference_pressure = 1e5, .kappa = kappa, .shear_modulus = G};
  law.hardening = IndexHardening{
      .preconsolidation = p * (1.0 + eta * eta / (M * M)), .lambda = lambda, .kappa = kappa};
  double const volume = kappa * std::log(p / 1e5), shear = eta * p / (3.0 * G);
  // Elastic strains of (p, q), axial compression, and a breath beyond so that the step yields.
  Eigen::Vector3d strain(-volume / 3.0 + shear / 2.0, -volume / 3.0 + shear / 2.0,
                         -volume / 3.0 - shear - 1e-10);
  auto const step = respond(law, {}, strain);
  ASSERT_TRUE(step);
  ASSERT_EQ(step->surface, PowderSurface::ellipse);
  Eigen::Vector3d const rate = -step->tangent.col(2);
  EXPECT_NEAR((rate[0] - rate[2]) / (-rate.sum() / 3.0), eta, 1e-5);
}

TEST(PowderCamClay, PressedPowderReachesTheRigidPlasticRatio) {
  auto law = powder();
  law.cohesion = 0.0;
  law.elasticity = DensityElasticity{.young_modulus = 2e12, .poisson_ratio = 0.2};
  PowderPoint point;
  auto const path = press_to_height(law, point, 0.45, 400);
  EXPECT_NEAR(path.stress_ratio.back(), lateral_ratio(virgin_stress_ratio(1.3, 1.0, 0.2)), 2e-4);
  EXPECT_NEAR(path.stress_ratio.back(), 0.6335, 2e-4); // tooling-fem.md 4
}

TEST(PowderCamClay, CohesionBearsTension) {
  auto const law = powder();
  // Isotropic tension: yields at p = -c and then at the c of a looser powder, which is the same.
  auto const step = respond(law, {}, Eigen::Vector3d::Constant(1e-3));
  ASSERT_TRUE(step);
  EXPECT_EQ(step->surface, PowderSurface::ellipse);
  EXPECT_NEAR(invariants(step->stress).p, -1e5, 1e-3);
  EXPECT_LT(step->state.plastic_compaction, 0.0);
  // The ellipse's ends and top: F = q^2 + M^2 (p + c)(p - p_c).
  auto const pressed = respond(law, {}, Eigen::Vector3d(-2e-3, -1e-3, -4e-3));
  ASSERT_TRUE(pressed);
  auto const [p, q] = invariants(pressed->stress);
  double const p_c = law.consolidation_pressure(pressed->state);
  EXPECT_NEAR((q * q + 1.3 * 1.3 * (p + 1e5) * (p - p_c)) / (p_c * p_c), 0.0, 1e-12);
}

// p + c = (p_0 + c) exp(eps_v/kappa), also into tension down to -c.
TEST(PowderCamClay, PressureElasticityCarriesItsCohesion) {
  PressureElasticity const bed{
      .reference_pressure = 1e5, .kappa = 0.01, .shear_modulus = 2e7, .cohesion = 4e4};
  EXPECT_TRUE(near::relative(bed(0.01, 0.0, 0.5).p, 1.4e5 * std::exp(1.0) - 4e4, 1e-14));
  EXPECT_LT(bed(-0.02, 0.0, 0.5).p, 0.0);
  EXPECT_GT(bed(-0.2, 0.0, 0.5).p, -4e4);
  EXPECT_TRUE(near::relative(bed(0.0, 0.003, 0.5).q, 3.0 * 2e7 * 0.003, 1e-14));
}

TEST(PowderCamClay, HeckelHardeningNeverReachesTheSolid) {
  auto const law = powder();
  PowderPoint point;
  auto const path = press_to_height(law, point, 0.36, 400); // the solid alone would be 0.35 high
  EXPECT_LT(path.relative_density.back(), 1.0);
  EXPECT_GT(path.axial_stress.back(), path.axial_stress[300]);
  double const D = path.relative_density.back();
  EXPECT_TRUE(near::relative(law.consolidation_pressure(point.powder),
                             1e6 + 30e6 * std::log(0.65 / (1.0 - D)), 1e-10));
}

TEST(PowderCamClay, TabulatedHardeningGoesOnSmoothly) {
  TabulatedHardening const table{{{0.35, 1e6}, {0.60, 20e6}, {0.80, 60e6}}};
  EXPECT_NEAR(table(0.0, 0.475), 10.5e6, 1e-3);
  double const h = 1e-6;
  EXPECT_NEAR((table(0.0, 0.8) - table(0.0, 0.8 - h)) / h, 200e6, 1e3);
  EXPECT_NEAR((table(0.0, 0.8 + h) - table(0.0, 0.8)) / h, 200e6, 2e3);
  EXPECT_NEAR(table(0.0, 0.9), 60e6 + 200e6 * 0.2 * std::log(2.0), 1e-3);
}

} // namespace
