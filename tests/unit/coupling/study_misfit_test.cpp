// What calibration stands on: misfits and their slopes, extremes of surfaces, the search in a box.
#include "coupling/study/box_minimum.hpp"
#include "coupling/study/calibration_misfit.hpp"
#include "coupling/study/design.hpp"
#include "coupling/study/surface_extremes.hpp"
#include "tests/support/near.hpp"
#include "tests/unit/coupling/study_seed.hpp"
#include "tests/unit/coupling/study_support.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace coupling::study;
using namespace study_support;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Rosenbrock's valley: r = (10 (y - x^2), 1 - x), least at (1, 1).
Residuals rosenbrock(VectorXd const& x) {
  return {VectorXd{{10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]}},
          MatrixXd{{-20.0 * x[0], 10.0}, {-1.0, 0.0}}};
}

Box square(double half) {
  return {VectorXd::Constant(2, -half), VectorXd::Constant(2, half)};
}

} // namespace

TEST(BoxMinimum, FollowsAValleyAndStopsAtAWall) {
  auto const inside = minimise_in(rosenbrock, square(2.0));
  EXPECT_NEAR(inside.x[0], 1.0, 1e-8);
  EXPECT_NEAR(inside.x[1], 1.0, 1e-8);
  // Up to x = 1/2 the valley y = x^2 lies inside and (1 - x)^2 falls towards the wall.
  auto const at_wall = minimise_in(rosenbrock, square(0.5));
  EXPECT_EQ(at_wall.x[0], 0.5);
  EXPECT_NEAR(at_wall.x[1], 0.25, 1e-9);
  EXPECT_NEAR(at_wall.value, 0.25, 1e-12);
}

TEST(BoxMinimum, FindsTheDeeperOfTwoValleys) {
  // r = x^2 - 1 and 0.1 (x - 1): zero at 1, 0.2^2 near -1.
  ResidualsAt const two = [](VectorXd const& x) {
    return Residuals{VectorXd{{x[0] * x[0] - 1.0, 0.1 * (x[0] - 1.0)}},
                     MatrixXd{{2.0 * x[0]}, {0.1}}};
  };
  Box const box{VectorXd::Constant(1, -3.0), VectorXd::Constant(1, 3.0)};
  EXPECT_NEAR(minimise_in(two, box).x[0], 1.0, 1e-8);
  EXPECT_LT(minimise_from(two, box, VectorXd::Constant(1, -2.0)).x[0], -0.9);
}

TEST(SurfaceExtremes, AreThoseOfAFineGrid) {
  Noise noise(5);
  MatrixXd const coded = full_factorial({3, 3, 3});
  VectorXd const low = VectorXd::Constant(3, -0.9), high = VectorXd::Constant(3, 0.8);
  for (int set = 0; set < 20; ++set) {
    auto const surface =
        fit_response_surface(observed(coded, noise.vector(27)), quadratic_terms(3));
    auto const found = extremes_of(surface, low, high);
    double least = 1e300, largest = -1e300;
    MatrixXd const grid = full_factorial({41, 41, 41});
    for (Eigen::Index k = 0; k < grid.rows(); ++k) {
      VectorXd const x =
          0.5 * (low + high) + 0.5 * (high - low).cwiseProduct(grid.row(k).transpose());
      least = std::min(least, surface.value(x));
      largest = std::max(largest, surface.value(x));
    }
    EXPECT_LE(found.lowest, least + 1e-12);
    EXPECT_NEAR(found.lowest, least, 0.01);
    EXPECT_GE(found.highest, largest - 1e-12);
    EXPECT_NEAR(found.highest, largest, 0.01);
    EXPECT_NEAR(surface.value(found.lowest_at), found.lowest, 1e-14);
  }
}

TEST(CalibrationMisfit, HasTheSlopeOfItsResidual) {
  std::vector<CalibrationTarget> targets;
  for (auto const& [column, value] :
       {std::pair("max_force [N]", 25095.0), std::pair("porosity [%]", 26.08)})
    targets.push_back({fit_response_surface(study_seed::observations("table7", "EDEM", column),
                                            quadratic_terms(2)),
                       value, 0.5});
  VectorXd const x{{0.3, -0.6}};
  constexpr double h = 1e-6;
  for (auto const spread : {SurfaceSpread::run, SurfaceSpread::mean})
    for (auto const& target : targets) {
      auto const at = residual_of(target, spread, x);
      for (int f = 0; f < 2; ++f) {
        VectorXd const step = h * VectorXd::Unit(2, f);
        double const slope = (residual_of(target, spread, x + step).value -
                              residual_of(target, spread, x - step).value) /
                             (2.0 * h);
        EXPECT_NEAR(at.slope[f], slope, 1e-7 * (1.0 + std::abs(slope)));
      }
      auto const said = target.surface.predict(x);
      double const own = spread == SurfaceSpread::run ? said.run_sd : said.mean_sd;
      EXPECT_TRUE(near::relative(at.combined_sd, std::hypot(target.sd, own), 1e-12));
      EXPECT_TRUE(near::relative(at.value, (said.value - target.value) / at.combined_sd, 1e-12));
    }
}
