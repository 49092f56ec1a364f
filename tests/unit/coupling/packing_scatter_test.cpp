#include "coupling/reduced/mean_cycle.hpp"
#include "coupling/reduced/packing_scatter.hpp"
#include "coupling/reduced/press_model.hpp"
#include "dem/expect.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace coupling;
using namespace coupling::reduced;

namespace {

using diagnosis::Phase;

Press const press{.pressed = {.law = {.stiffness = 60e6,
                                      .cohesion = 1e6,
                                      .onset = 0.54,
                                      .exponent = 1.8,
                                      .recovery = 0.8,
                                      .wall_friction = 0.15,
                                      .radial_ratio = 0.5},
                              .bed = {.solid_area = 7e-3, .bore = 22e-3}},
                  .machine = {},
                  .solid_density = 3400.0};

/// A row of the same place in each of the channels, in loading and in unloading; the height.
PlannedRun run(std::string const& name, double end_gap) {
  PlannedRun planned{.name = name,
                     .course = press_course(20e-3, end_gap, 0.1, 0.1),
                     .times = {0.095, 0.110, (20e-3 - end_gap) / 0.1, 0.125},
                     .blocks = {}};
  std::ranges::sort(planned.times);
  for (auto const* const channel :
       {"upper_punch_force", "lower_punch_force", "wall_radial_pressure"})
    planned.blocks.push_back(
        {.channel = channel, .phase = Phase::loading, .rows = {{{0, 0}}, {{1, 1}}, {{2, 2}}}});
  planned.blocks.push_back(
      {.channel = "upper_punch_force", .phase = Phase::unloading, .rows = {{{3, 3}}}});
  planned.blocks.push_back(
      {.channel = "compact_height", .phase = Phase::after, .rows = {{{0, 0}}}});
  return planned;
}

double matern(double d, double l) {
  return (1.0 + std::sqrt(3.0) * d / l) * std::exp(-std::sqrt(3.0) * d / l);
}

SimulatedCycle cycle(double scale, double place) {
  SimulatedCycle made;
  auto const add = [&](double height, double force) {
    made.height.push_back(height);
    made.upper.push_back(scale * force);
    made.lower.push_back(0.8 * scale * force);
    made.radial_pressure.push_back(2.0 * scale * force);
  };
  for (double h = 12e-3 - place; h > 8e-3; h -= 1e-4)
    add(h, 1e6 * std::max(11e-3 - h, 0.0));
  add(8e-3, 3000.0);
  for (double h = 8.05e-3 + place; h < 9.9e-3; h += 1e-4)
    add(h, std::max(2e6 * (9.5e-3 - h), 0.0));
  return made;
}

} // namespace

TEST(PackingScatter, GoesAsMeansOverGrainsDo) {
  auto const coarse = packing_scatter(2204), fine = packing_scatter(4 * 2204);
  EXPECT_DOUBLE_EQ(coarse.stress, 0.011);
  EXPECT_DOUBLE_EQ(fine.stress, 0.0055);
  EXPECT_DOUBLE_EQ(fine.punch, 0.001);
  EXPECT_DOUBLE_EQ(fine.wall_stress, 0.0025);
  EXPECT_DOUBLE_EQ(fine.wall, 0.0053);
  EXPECT_DOUBLE_EQ(fine.free_height, 0.0012);
  EXPECT_EQ(packing_scatter(0).stress, 0.0);
}

TEST(PackingScatter, IsTheFormula) {
  PressPlan const plan{.runs = {run("a", 8e-3)}};
  PackingScatter const of{
      .stress = 0.02, .punch = 0.003, .wall_stress = 0.007, .wall = 0.013, .free_height = 0.004};
  auto const C = packing_covariance(press, plan, of);
  auto const f = predict_plan(press, plan);
  ASSERT_EQ(f.size(), 11);
  auto const height = [](double t) { return 20e-3 - 0.1 * t; };
  double const closing = std::log(height(0.095) / height(0.110));
  double const own = matern(closing, 0.02) / 3.0 + 2.0 * matern(closing, 0.12) / 3.0;
  double const with = 0.5 + 0.5 * matern(closing, 0.045);
  EXPECT_NEAR(C(0, 0), (0.02 * 0.02 + 0.003 * 0.003) * f[0] * f[2], 1e-9 * C(0, 0));
  EXPECT_NEAR(C(0, 1), f[2] * std::sqrt(f[0] * f[1]) * (0.02 * 0.02 * with + 0.003 * 0.003 * own),
              1e-9 * C(0, 0));
  EXPECT_NEAR(C(0, 3), 0.02 * 0.02 * std::sqrt(f[0] * f[2] * f[3] * f[5]), 1e-9 * C(0, 0));
  EXPECT_NEAR(C(0, 6), 0.02 * 0.007 * std::sqrt(f[0] * f[2] * f[6] * f[8]), 1e-9 * C(0, 6));
  EXPECT_NEAR(C(6, 7),
              f[8] * std::sqrt(f[6] * f[7]) *
                  (0.007 * 0.007 * with + 0.013 * 0.013 * matern(closing, 0.08)),
              1e-9 * C(6, 6));
  // Opening counts for less than closing, and is apart from it.
  double const opening = std::log((8e-3 + 0.1 * 0.005) / 8e-3) / 2.5;
  double const turned = std::log(height(0.110) / 8e-3);
  EXPECT_NEAR(C(2, 9) / f[2] / std::sqrt(f[2] * f[9]),
              0.02 * 0.02 * (0.5 + 0.5 * matern(opening, 0.045)) +
                  0.003 * 0.003 * (matern(opening, 0.02) / 3.0 + 2.0 * matern(opening, 0.12) / 3.0),
              1e-9);
  EXPECT_LT(C(1, 9) / std::sqrt(C(1, 1) * C(9, 9)),
            0.5 + 0.5 * matern(std::hypot(turned, opening), 0.045) + 1e-3);
  EXPECT_NEAR(C(10, 10), std::pow(0.004 * f[10], 2), 1e-12 * f[10] * f[10]);
  EXPECT_EQ(C(10, 0), 0.0);
}

TEST(PackingScatter, IsACovarianceOverRunsToo) {
  PressPlan const plan{.runs = {run("a", 8e-3), run("b", 8.2e-3)}};
  auto const C = packing_covariance(press, plan, packing_scatter(2204));
  Eigen::VectorXd const sd = C.diagonal().cwiseSqrt();
  Eigen::MatrixXd const R = sd.cwiseInverse().asDiagonal() * C * sd.cwiseInverse().asDiagonal();
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> const found(R);
  EXPECT_GT(found.eigenvalues().minCoeff(), -1e-10);
  EXPECT_GT(R(0, 11), 0.9); // both runs pass the same height with the same packing
  auto const apart = apart_by_run(C, plan);
  EXPECT_EQ(apart.block(0, 11, 11, 11).norm() + apart.block(11, 0, 11, 11).norm(), 0.0);
  EXPECT_EQ((apart - C).block(0, 0, 11, 11).norm() + (apart - C).block(11, 11, 11, 11).norm(), 0.0);
}

TEST(MeanCycle, OfOneIsItself) {
  std::vector const one{cycle(1.0, 0.0)};
  EXPECT_EQ(mean_cycle(one).upper, one[0].upper);
  EXPECT_EQ(mean_cycle(one).height, one[0].height);
}

TEST(MeanCycle, TakesForcesAtTheSameHeights) {
  std::vector const packings{cycle(1.0, 0.0), cycle(0.9, 3e-5), cycle(1.1, 7e-5)};
  auto const mean = mean_cycle(packings);
  auto const& first = packings[0];
  double const peak = 3000.0;
  ASSERT_GT(mean.height.size(), 50u);
  for (std::size_t k = 0; k < mean.height.size(); ++k) {
    auto const at = static_cast<std::size_t>(std::ranges::find(first.height, mean.height[k]) -
                                             first.height.begin());
    ASSERT_LT(at, first.height.size());
    // Near the corners of these straight curves an interpolated record cuts across.
    EXPECT_NEAR(mean.upper[k], first.upper[at], 0.01 * peak) << mean.height[k];
    EXPECT_NEAR(mean.lower[k], 0.8 * mean.upper[k], 1e-9 * peak);
    EXPECT_NEAR(mean.radial_pressure[k], 2.0 * mean.upper[k], 1e-9 * peak);
  }
  EXPECT_NEAR(*std::ranges::max_element(mean.upper), peak, 1e-9 * peak);
}

TEST(MeanCycle, RefusesOtherProgrammes) {
  std::vector packings{cycle(1.0, 0.0), cycle(1.0, 0.0)};
  for (double& h : packings[1].height)
    h += 1e-4;
  EXPECT_THROW((void)mean_cycle(packings), dem::InvalidInput);
}
