// Consistent tangents against central differences, on every surface and edge.
#include "continuum/powder/avicel_ph102.hpp"
#include "continuum/powder/powder_law.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <vector>

namespace {

using namespace continuum;

/// |tangent - central difference| / (|tangent| + 1e4 Pa), since at an apex of constant strength the
/// tangent is zero; nothing if a neighbour ends on another surface or
/// beyond a row of a table, where the law has a kink.
std::optional<double> deviation(PowderLaw const& law, PowderState const& state,
                                Eigen::Vector3d const& strain, double h) {
  auto const here = respond(law, state, strain);
  if (!here)
    return std::nullopt;
  Eigen::Matrix3d difference;
  for (int i = 0; i < 3; ++i) {
    auto const above = respond(law, state, strain + h * Eigen::Vector3d::Unit(i));
    auto const below = respond(law, state, strain - h * Eigen::Vector3d::Unit(i));
    if (!above || !below || above->surface != here->surface || below->surface != here->surface)
      return std::nullopt;
    difference.col(i) = (above->stress - below->stress) / (2.0 * h);
  }
  return (difference - here->tangent).norm() / (here->tangent.norm() + 1e4);
}

struct Tally {
  int n = 0;
  double largest = 0.0;
};

std::map<PowderSurface, Tally> tally(PowderLaw const& law, double largest_compaction, double size) {
  std::mt19937 random(20261124);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> compaction(-0.02, largest_compaction);
  std::map<PowderSurface, Tally> result;
  for (int i = 0; i < 1500; ++i) {
    PowderState const state{.plastic_compaction = compaction(random)};
    Eigen::Vector3d strain(normal(random), normal(random), normal(random));
    strain *= size * std::exp(normal(random));
    if (auto const error = deviation(law, state, strain, 1e-7)) {
      auto& entry = result[respond(law, state, strain)->surface];
      ++entry.n;
      entry.largest = std::max(entry.largest, *error);
    }
  }
  return result;
}

void expect_exact(PowderLaw const& law, std::vector<PowderSurface> const& surfaces,
                  double largest_compaction, double size) {
  auto const found = tally(law, largest_compaction, size);
  for (PowderSurface const surface : surfaces) {
    ASSERT_TRUE(found.contains(surface)) << name_of(surface);
    EXPECT_GE(found.at(surface).n, 10) << name_of(surface);
    EXPECT_LT(found.at(surface).largest, 2e-6) << name_of(surface);
  }
}

using enum PowderSurface;

TEST(PowderTangent, OfTheCap) {
  for (auto const flow : {ShearFlow::elliptic, ShearFlow::admissible}) {
    auto law = avicel_ph102(HardeningReading::consistent);
    law.shear_flow = flow;
    expect_exact(law, {none, cap, shear}, 0.9, 5e-3);
    law.transition = 0.03;
    expect_exact(law, {none, cap, transition, shear}, 0.9, 2e-2);
    law.tension_cut_off = 0.3;
    expect_exact(law, {none, shear, tension, edge}, 0.9, 1e-3);
  }
  auto law = avicel_ph102(HardeningReading::as_filed);
  law.shear_flow = ShearFlow::admissible;
  expect_exact(law, {none, cap, shear, edge}, 0.9, 5e-3); // here the edge is the apex
}

TEST(PowderTangent, OfCamClay) {
  ModifiedCamClay law{
      .slope = 1.2,
      .initial_relative_density = 0.5,
      .elasticity =
          PressureElasticity{.reference_pressure = 1e5, .kappa = 0.02, .shear_modulus = 5e6},
      .hardening = IndexHardening{.preconsolidation = 1.5e5, .lambda = 0.05, .kappa = 0.02}};
  expect_exact(law, {none, ellipse}, 0.2, 1e-2);
  law.cohesion = 1e5;
  law.elasticity =
      DensityElasticity{.young_modulus = {{0.3, 1e8}, {1.0, 5e9}}, .poisson_ratio = 0.2};
  law.hardening =
      HeckelHardening{.initial_pressure = 1e6, .yield_pressure = 30e6, .reference_density = 0.5};
  expect_exact(law, {none, ellipse}, 0.5, 5e-3);
  law.hardening = TabulatedHardening{{{0.4, 1e6}, {0.6, 20e6}, {0.8, 60e6}}};
  expect_exact(law, {none, ellipse}, 0.5, 5e-3);
}

TEST(PowderTangent, DifferencesConvergeToItAtSecondOrder) {
  ModifiedCamClay const law{
      .slope = 1.3,
      .cohesion = 1e5,
      .initial_relative_density = 0.35,
      .elasticity = DensityElasticity{.young_modulus = 2e9, .poisson_ratio = 0.2},
      .hardening = HeckelHardening{
          .initial_pressure = 1e6, .yield_pressure = 30e6, .reference_density = 0.35}};
  Eigen::Vector3d const strain(-0.01, 0.002, -0.03);
  double const coarse = *deviation(law, {}, strain, 4e-4);
  double const fine = *deviation(law, {}, strain, 2e-4);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.02);
}

TEST(PowderTangent, WithEqualPrincipalStrains) {
  for (auto const flow : {ShearFlow::elliptic, ShearFlow::admissible}) {
    auto law = avicel_ph102(HardeningReading::consistent);
    law.shear_flow = flow;
    PowderState const state{.plastic_compaction = 0.5};
    for (Eigen::Vector3d const& strain :
         {Eigen::Vector3d(-0.02, -0.02, -0.02), Eigen::Vector3d(-1e-5, -1e-5, -1e-5),
          Eigen::Vector3d(-0.001, -0.001, -0.04), Eigen::Vector3d(0.004, -0.01, -0.01)}) {
      auto const error = deviation(law, state, strain, 1e-7);
      ASSERT_TRUE(error);
      EXPECT_LT(*error, 2e-6) << strain.transpose();
    }
  }
}

// Newton's iteration for the strain of a given stress: each residual below a multiple of the square
// of the one before.
TEST(PowderTangent, NewtonConvergesQuadratically) {
  auto const law = avicel_ph102(HardeningReading::consistent);
  PowderState const state{.plastic_compaction = std::log(0.62 / 0.3411)};
  auto const aim = law.respond(state, {-0.004, -0.003, -0.030});
  ASSERT_TRUE(aim);
  ASSERT_EQ(aim->surface, cap);
  Eigen::Vector3d strain(-0.003, -0.002, -0.027);
  std::vector<double> residuals;
  for (int i = 0; i < 8; ++i) {
    auto const now = law.respond(state, strain);
    ASSERT_TRUE(now);
    Eigen::Vector3d const gap = aim->stress - now->stress;
    residuals.push_back(gap.norm() / aim->stress.norm());
    if (residuals.back() < 1e-13)
      break;
    strain += now->tangent.partialPivLu().solve(gap);
  }
  ASSERT_GE(residuals.size(), 4U);
  EXPECT_LE(residuals.size(), 7U);
  for (std::size_t i = 2; i + 1 < residuals.size(); ++i)
    EXPECT_LT(residuals[i + 1], 10.0 * residuals[i] * residuals[i] + 1e-13) << i;
}

// The tangent is unsymmetric where flow is not associated, and symmetric for Cam-Clay's elastic
// step.
TEST(PowderTangent, SymmetryWhereThereIsAnEnergy) {
  auto const law = avicel_ph102(HardeningReading::consistent);
  PowderState const state{.plastic_compaction = 0.5};
  auto const elastic = law.respond(state, {-1e-4, -2e-4, -3e-4});
  EXPECT_LT((elastic->tangent - elastic->tangent.transpose()).norm(),
            1e-12 * elastic->tangent.norm());
  auto const sheared = law.respond(state, {2e-3, 1e-3, -5e-3});
  ASSERT_EQ(sheared->surface, shear);
  EXPECT_GT((sheared->tangent - sheared->tangent.transpose()).norm(),
            1e-2 * sheared->tangent.norm());
}

} // namespace
