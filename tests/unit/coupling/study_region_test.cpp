// The border of the joint region against the ellipse that it is for linear surfaces.
#include "coupling/study/design.hpp"
#include "coupling/study/distributions.hpp"
#include "coupling/study/joint_region.hpp"
#include "tests/support/near.hpp"
#include "tests/unit/coupling/study_support.hpp"

#include <Eigen/LU>

#include <gtest/gtest.h>

#include <numbers>

namespace {

using namespace coupling::study;
using namespace study_support;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Without noise: y = b0 + b . coded.
ResponseSurface plane(double b0, VectorXd const& b) {
  MatrixXd const coded = full_factorial(std::vector<int>(static_cast<std::size_t>(b.size()), 3));
  return fit_response_surface(observed(coded, (coded * b).array() + b0),
                              linear_terms(static_cast<int>(b.size())));
}

/// Coded -1 to 1 is 10 to 30 for A, 0 to 4 for B, 100 to 200 for C.
std::vector<CalibrationFactor> factors(std::size_t n) {
  std::vector<CalibrationFactor> const all{{{"A", 10.0, 30.0}, 10.0, 30.0, {}},
                                           {{"B", 0.0, 4.0}, 0.0, 4.0, {}},
                                           {{"C", 100.0, 200.0}, 100.0, 200.0, {}}};
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n)};
}

/// Half the range of each factor: natural = centre + half coded.
Eigen::Vector3d const half{10.0, 2.0, 50.0};
Eigen::Vector3d const centre{20.0, 2.0, 150.0};

double area(ContourLine const& line) {
  double twice = 0.0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
    twice += line[k][0] * line[k + 1][1] - line[k + 1][0] * line[k][1];
  return 0.5 * std::abs(twice);
}

double chi_squared_95_of_2 = -2.0 * std::log(0.05); // exactly: 5.9915

} // namespace

TEST(ContourLines, AreCirclesAndStopAtTheGrid) {
  auto const radius = [](double x, double y) { return std::hypot(x, y); };
  auto const whole = contour_lines(radius, {-2.0, 2.0, 41}, {-2.0, 2.0, 41}, 1.0);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].front(), whole[0].back());
  for (auto const& [x, y] : whole[0])
    EXPECT_NEAR(radius(x, y), 1.0, 1e-9);
  // 0.9 and 1.1 would be off by 19 %.
  EXPECT_TRUE(near::relative(area(whole[0]), std::numbers::pi, 5e-3));
  auto const halved = contour_lines(radius, {0.0, 2.0, 41}, {-2.0, 2.0, 41}, 1.0);
  ASSERT_EQ(halved.size(), 1u);
  EXPECT_EQ(std::abs(halved[0].front()[1]), 1.0);
  EXPECT_NEAR(halved[0].front()[1], -halved[0].back()[1], 1e-9);
}

// x y = 0.01 in a cell about the origin: the lines pass the corners where both have one sign.
TEST(ContourLines, DecideASaddleByItsMiddle) {
  auto const saddle = [](double x, double y) { return x * y; };
  for (double const level : {0.01, -0.01}) {
    auto const lines = contour_lines(saddle, {-1.0, 1.0, 2}, {-1.0, 1.0, 2}, level);
    ASSERT_EQ(lines.size(), 2u);
    for (auto const& line : lines)
      for (std::size_t k = 1; k < line.size(); ++k) // x and y keep the sign of the level
        EXPECT_EQ((line[k][0] + line[k - 1][0]) * (line[k][1] + line[k - 1][1]) > 0.0, level > 0.0);
  }
}

TEST(JointRegion, OfPlanesIsTheEllipse) {
  // Residuals (y_j - t_j) / s_j with slopes g_j / s_j in coded units; the best point is coded
  // (0.1, -0.2), where both targets are met.
  VectorXd const g1{{2.0, 1.0}}, g2{{-1.0, 2.5}}, best{{0.1, -0.2}};
  double const s1 = 0.2, s2 = 0.5;
  CalibrationProblem const problem{.factors = factors(2),
                                   .targets = {{plane(3.0, g1), 3.0 + g1.dot(best), s1},
                                               {plane(-1.0, g2), -1.0 + g2.dot(best), s2}}};
  auto const found = calibrate(problem);
  auto const regions = joint_regions(problem, found);
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(regions[0].first, 0);
  EXPECT_EQ(regions[0].second, 1);
  EXPECT_NEAR(regions[0].threshold, chi_squared_95_of_2, 1e-9);
  ASSERT_EQ(regions[0].lines.size(), 1u);
  auto const& border = regions[0].lines[0];
  EXPECT_EQ(border.front(), border.back());
  MatrixXd const A = g1 * g1.transpose() / (s1 * s1) + g2 * g2.transpose() / (s2 * s2);
  double most_A = 0.0;
  for (auto const& [a, b] : border) {
    VectorXd const x{{(a - centre[0]) / half[0] - best[0], (b - centre[1]) / half[1] - best[1]}};
    EXPECT_TRUE(near::relative(x.dot(A * x), chi_squared_95_of_2, 1e-7));
    most_A = std::max(most_A, a);
  }
  // Area pi q / sqrt(det A), in natural units times 10 x 2; the extent sqrt(q (A^-1)_aa).
  double const ellipse =
      std::numbers::pi * chi_squared_95_of_2 / std::sqrt(A.determinant()) * half[0] * half[1];
  EXPECT_TRUE(near::relative(area(border), ellipse, 1e-3));
  double const reach = std::sqrt(chi_squared_95_of_2 * A.inverse()(0, 0));
  EXPECT_NEAR(most_A, centre[0] + half[0] * (best[0] + reach), 1e-3 * half[0]);
  EXPECT_NEAR(found.factors[0].region_upper, centre[0] + half[0] * (best[0] + reach), 1e-5);
}

// Three planes for three factors: the third is minimised away, A_ab - A_ac A_cb / A_cc.
TEST(JointRegion, OfThreeFactorsIsTheEllipsesShadow) {
  std::vector<VectorXd> const g{VectorXd{{2.0, 1.0, 0.5}}, VectorXd{{-1.0, 2.5, 0.3}},
                                VectorXd{{0.4, -0.6, 1.5}}};
  CalibrationProblem problem{.factors = factors(3), .targets = {}};
  MatrixXd A = MatrixXd::Zero(3, 3);
  for (auto const& slope : g) {
    problem.targets.push_back({plane(1.0, slope), 1.0, 0.2});
    A += slope * slope.transpose() / 0.04;
  }
  auto const regions = joint_regions(problem, calibrate(problem));
  ASSERT_EQ(regions.size(), 3u); // A B, A C, B C
  EXPECT_EQ(regions[1].first, 0);
  EXPECT_EQ(regions[1].second, 2);
  double const q = chi_squared_quantile(0.95, 3); // 7.815
  EXPECT_NEAR(q, 7.8147, 1e-4);
  for (auto const& region : regions) {
    int const a = region.first, b = region.second, c = 3 - a - b;
    ASSERT_EQ(region.lines.size(), 1u);
    for (auto const& [u, v] : region.lines[0]) {
      double const x = (u - centre[a]) / half[a], y = (v - centre[b]) / half[b];
      double const chi = (A(a, a) - A(a, c) * A(a, c) / A(c, c)) * x * x +
                         2.0 * (A(a, b) - A(a, c) * A(b, c) / A(c, c)) * x * y +
                         (A(b, b) - A(b, c) * A(b, c) / A(c, c)) * y * y;
      EXPECT_TRUE(near::relative(chi, q, 1e-5));
    }
  }
}

TEST(JointRegion, StopsAtABoundAndNeedsTwoFreeFactors) {
  // The target wants coded A = 0.95: the region reaches over 1.
  VectorXd const g1{{1.0, 0.0}}, g2{{0.0, 1.0}};
  CalibrationProblem problem{.factors = factors(2),
                             .targets = {{plane(0.0, g1), 0.95, 0.1}, {plane(0.0, g2), 0.0, 0.1}}};
  auto const regions = joint_regions(problem, calibrate(problem));
  ASSERT_EQ(regions.size(), 1u);
  ASSERT_EQ(regions[0].lines.size(), 1u);
  EXPECT_EQ(regions[0].lines[0].front()[0], 30.0);
  EXPECT_EQ(regions[0].lines[0].back()[0], 30.0);
  problem.factors[1].held = 2.0;
  EXPECT_TRUE(joint_regions(problem, calibrate(problem)).empty());
}
