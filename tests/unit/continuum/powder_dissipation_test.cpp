// Plastic work on the shear line: where Abaqus' potential gives energy, and that the other does
// not.
#include "continuum/powder/avicel_ph102.hpp"
#include "tests/support/near.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace continuum;

double compaction_at(DruckerPragerCap const& law, double density) {
  return std::log(density / law.initial_relative_density);
}

// With q = d + p t and G = sqrt[(p_a - p)^2 t^2 + q^2] work has the sign of
//     d^2 + (2 d t - p_a t^2) p + 2 t^2 p^2,
// negative between p t = [p_a t - 2 d -+ sqrt((p_a t - 2 d)^2 - 8 d^2)]/4, which needs
// p_a t > 2 (1 + sqrt 2) d.
TEST(PowderDissipation, AbaqusPotentialGivesEnergyAtSmallCohesion) {
  auto const law = avicel_ph102(HardeningReading::consistent);
  for (double const density : {0.40, 0.50, 0.60, 0.70, 0.80, 0.90}) {
    auto const s = cap_shape(law, compaction_at(law, density));
    auto const found = dissipation(law, compaction_at(law, density));
    double const excess = s.p_a * s.tan_b - 2.0 * s.d;
    bool const is_negative = s.p_a * s.tan_b > 2.0 * (1.0 + std::sqrt(2.0)) * s.d;
    EXPECT_EQ(is_negative, density < 0.75); // 7.5, 8.8, 5.7, 5.0 d; then 4.45 and 4.44
    EXPECT_EQ(found.is_admissible(), !is_negative) << density;
    if (!is_negative)
      continue;
    double const root = std::sqrt(excess * excess - 8.0 * s.d * s.d);
    double const step = (s.p_a - s.p_tension) / 4000.0;
    EXPECT_NEAR(found.negative_from, (excess - root) / (4.0 * s.tan_b), step) << density;
    EXPECT_NEAR(found.negative_to, (excess + root) / (4.0 * s.tan_b), step) << density;
  }
}

// Flow by the parabola: work per shear is d + p t (d + p t)/D_c, least at p t = -d/2.
TEST(PowderDissipation, CorrectedFlowKeepsItAboveThreeQuartersOfTheCohesion) {
  auto law = avicel_ph102(HardeningReading::consistent);
  law.shear_flow = ShearFlow::admissible;
  for (double const density : {0.40, 0.50, 0.60, 0.70, 0.80, 0.90}) {
    auto const s = cap_shape(law, compaction_at(law, density));
    auto const found = dissipation(law, compaction_at(law, density));
    EXPECT_TRUE(near::relative(found.least, s.d * (1.0 - s.d / (4.0 * s.D_c)), 1e-6));
    law.transition = 0.03;
    EXPECT_TRUE(dissipation(law, compaction_at(law, density)).is_admissible());
    law.transition = 0.0;
  }
}

/// A step from the shear line at p, sheared on; plastic work [J/m^3].
double work_of_shearing(DruckerPragerCap const& law, double density, double p) {
  PowderState const state{.plastic_compaction = compaction_at(law, density)};
  auto const s = cap_shape(law, state.plastic_compaction);
  double const E = law.elasticity.young_modulus(density);
  double const nu = law.elasticity.poisson_ratio(density);
  double const volume = p * 3.0 * (1.0 - 2.0 * nu) / E;
  double const shear = (s.d + p * s.tan_b) * 2.0 * (1.0 + nu) / (3.0 * E) + 1e-6;
  auto const step = law.respond(
      state, {-volume / 3.0 + shear / 2.0, -volume / 3.0 + shear / 2.0, -volume / 3.0 - shear});
  EXPECT_TRUE(step && step->surface == PowderSurface::shear);
  return step->plastic_work;
}

TEST(PowderDissipation, StepsDoTheWorkOfTheirPotential) {
  auto law = avicel_ph102(HardeningReading::consistent);
  double const inside = 0.8e6, outside = 3e6; // of the range 0.42 to 1.90 MPa at 0.60
  EXPECT_LT(work_of_shearing(law, 0.60, inside), 0.0);
  EXPECT_GT(work_of_shearing(law, 0.60, outside), 0.0);
  law.shear_flow = ShearFlow::admissible;
  EXPECT_GT(work_of_shearing(law, 0.60, inside), 0.0);
  EXPECT_GT(work_of_shearing(law, 0.60, outside), 0.0);
}

TEST(PowderDissipation, ManyStepsOfAbaqusPotentialGiveEnergy) {
  auto law = avicel_ph102(HardeningReading::consistent);
  for (auto const flow : {ShearFlow::elliptic, ShearFlow::admissible}) {
    law.shear_flow = flow;
    std::mt19937 random(1);
    std::normal_distribution<double> normal(0.0, 3e-3);
    std::uniform_real_distribution<double> compaction(-0.02, 1.0);
    int n = 0, n_negative = 0;
    for (int i = 0; i < 4000; ++i) {
      PowderState const state{.plastic_compaction = compaction(random)};
      auto const step = law.respond(state, {normal(random), normal(random), normal(random)});
      if (!step || step->surface != PowderSurface::shear)
        continue;
      ++n;
      n_negative += step->plastic_work < 0.0 ? 1 : 0;
    }
    if (flow == ShearFlow::elliptic)
      EXPECT_NEAR(static_cast<double>(n_negative) / n, 0.40, 0.04);
    else
      EXPECT_EQ(n_negative, 0);
  }
}

// Where plastic strain goes on the shear line, by the formulas of the two potentials.
TEST(PowderDissipation, DilatancyOfBothPotentials) {
  for (auto const flow : {ShearFlow::elliptic, ShearFlow::admissible}) {
    auto law = avicel_ph102(HardeningReading::consistent);
    law.shear_flow = flow;
    PowderState const state{.plastic_compaction = compaction_at(law, 0.80)};
    auto const trial = Eigen::Vector3d(2e-3, 2e-3, -6e-3);
    auto const step = law.respond(state, trial);
    ASSERT_TRUE(step && step->surface == PowderSurface::shear);
    auto const s = cap_shape(law, step->state.plastic_compaction);
    auto const [p, q] = invariants(step->stress);
    Eigen::Vector3d const plastic = trial - step->elastic_strain;
    double const dilation = plastic.sum();
    double const shear = std::sqrt(2.0 / 3.0) * (plastic.array() - plastic.mean()).matrix().norm();
    double const t = s.tan_b;
    double const expected =
        flow == ShearFlow::elliptic ? (s.p_a - p) * t * t / q : (s.p_a - p) * t * t / s.D_c;
    EXPECT_NEAR(dilation / shear, expected, 1e-9);
    EXPECT_NEAR(q, s.d + p * t, 1.0); // Pa of 1e7
    // Work is stress times plastic strain, and volume change is the density's.
    EXPECT_TRUE(near::relative(step->plastic_work, step->stress.dot(plastic), 1e-12));
    EXPECT_NEAR(step->state.plastic_compaction - state.plastic_compaction, -dilation, 1e-15);
  }
}

} // namespace
