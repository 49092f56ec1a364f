// Fits of pressure-density curves: exact data give the parameters back, scattered data give errors
// that are those of repeated draws.
#include "continuum/powder/compaction_curve.hpp"
#include "tests/support/near.hpp"
#include "tests/unit/continuum/refusal.hpp"

#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace continuum;

constexpr double MPa = 1e6;
PressureRange const everything{0.0, 1e12};

std::vector<double> pressures() {
  std::vector<double> result;
  for (int i = 1; i <= 40; ++i)
    result.push_back(5.0 * MPa * i);
  return result;
}

template <class Curve>
std::vector<double> densities(Curve const& curve, double scatter = 0.0, unsigned seed = 0) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, 1.0);
  std::vector<double> result;
  for (double const P : pressures())
    result.push_back(curve.density(P) + scatter * normal(random));
  return result;
}

Heckel const heckel{.slope = 1.0 / (80.0 * MPa), .intercept = 0.6};
Kawakita const kawakita{.a = 0.55, .b = 1.0 / (12.0 * MPa), .initial_density = 0.35};
CooperEaton const cooper_eaton{
    .a_1 = 0.55, .k_1 = 8.0 * MPa, .a_2 = 0.40, .k_2 = 120.0 * MPa, .initial_density = 0.35};

TEST(CompactionCurve, FormulasOfTheLaws) {
  EXPECT_NEAR(std::log(1.0 / (1.0 - heckel.density(40.0 * MPa))), 0.5 + 0.6, 1e-14);
  EXPECT_NEAR(heckel.pressure(heckel.density(33.0 * MPa)), 33.0 * MPa, 1e-6);
  EXPECT_NEAR(heckel.yield_pressure(), 80.0 * MPa, 1e-6);
  // C = a/2 at P = 1/b.
  EXPECT_NEAR(1.0 - 0.35 / kawakita.density(12.0 * MPa), 0.55 / 2.0, 1e-14);
  EXPECT_NEAR(kawakita.pressure(kawakita.density(33.0 * MPa)), 33.0 * MPa, 1e-6);
  double const D = cooper_eaton.density(30.0 * MPa);
  EXPECT_NEAR((1.0 / 0.35 - 1.0 / D) / (1.0 / 0.35 - 1.0),
              0.55 * std::exp(-8.0 / 30.0) + 0.40 * std::exp(-4.0), 1e-14);
  EXPECT_EQ(cooper_eaton.density(0.0), 0.35);
}

TEST(CompactionCurve, ExactDataGiveTheParameters) {
  auto const h = fit_heckel(pressures(), densities(heckel), everything);
  EXPECT_TRUE(near::relative(h.curve.slope, heckel.slope, 1e-9));
  EXPECT_TRUE(near::relative(h.curve.intercept, heckel.intercept, 1e-9));
  EXPECT_LT(h.residual, 1e-12);
  auto const k = fit_kawakita(pressures(), densities(kawakita), everything, 0.35);
  EXPECT_TRUE(near::relative(k.curve.a, kawakita.a, 1e-9));
  EXPECT_TRUE(near::relative(k.curve.b, kawakita.b, 1e-9));
  auto const c = fit_cooper_eaton(pressures(), densities(cooper_eaton), everything, 0.35);
  EXPECT_TRUE(near::relative(c.curve.a_1, cooper_eaton.a_1, 1e-6));
  EXPECT_TRUE(near::relative(c.curve.k_1, cooper_eaton.k_1, 1e-6));
  EXPECT_TRUE(near::relative(c.curve.a_2, cooper_eaton.a_2, 1e-6));
  EXPECT_TRUE(near::relative(c.curve.k_2, cooper_eaton.k_2, 1e-6));
}

/// Deviations of a parameter in units of its own standard error, over draws.
struct Scores {
  double sum = 0.0, squares = 0.0;
  int n = 0;
  void add(double value, double truth, double error) {
    double const score = (value - truth) / error;
    sum += score;
    squares += score * score;
    ++n;
  }
  /// Mean 0 +- 1/sqrt(n) and variance 1 +- sqrt(2/n): four of each.
  void expect_honest() const {
    EXPECT_NEAR(sum / n, 0.0, 4.0 / std::sqrt(n));
    EXPECT_NEAR(squares / n, 1.0, 4.0 * std::sqrt(2.0 / n));
  }
};

TEST(CompactionCurve, StandardErrorsAreHonest) {
  Scores slope, intercept, a, b, k_1, k_2;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    auto const h = fit_heckel(pressures(), densities(heckel, 2e-3, seed), everything);
    slope.add(h.curve.slope, heckel.slope, h.standard_error.slope);
    intercept.add(h.curve.intercept, heckel.intercept, h.standard_error.intercept);
    auto const k = fit_kawakita(pressures(), densities(kawakita, 2e-3, seed), everything, 0.35);
    a.add(k.curve.a, kawakita.a, k.standard_error.a);
    b.add(k.curve.b, kawakita.b, k.standard_error.b);
    if (seed > 100)
      continue;
    auto const c =
        fit_cooper_eaton(pressures(), densities(cooper_eaton, 2e-4, seed), everything, 0.35);
    k_1.add(c.curve.k_1, cooper_eaton.k_1, c.standard_error.k_1);
    k_2.add(c.curve.k_2, cooper_eaton.k_2, c.standard_error.k_2);
    EXPECT_NEAR(c.residual, 2e-4, 1.2e-4);
  }
  for (auto const* scores : {&slope, &intercept, &a, &b, &k_1, &k_2})
    scores->expect_honest();
}

TEST(CompactionCurve, TellsTheRangeItUsed) {
  auto const fit = fit_heckel(pressures(), densities(heckel), {22.0 * MPa, 101.0 * MPa});
  EXPECT_EQ(fit.n_points, 16U);
  EXPECT_EQ(fit.range.from, 25.0 * MPa);
  EXPECT_EQ(fit.range.to, 100.0 * MPa);
}

TEST(CompactionCurve, Refusals) {
  auto const P = pressures();
  auto const D = densities(heckel);
  expect_refusal([&] { fit_heckel(P, std::span(D).first(3), everything); },
                 "40 pressures and 3 densities");
  expect_refusal([&] { fit_heckel(P, D, {0.0, 11.0 * MPa}); }, "2 points from 0 to 1.1e+07 Pa");
  expect_refusal([&] { fit_cooper_eaton(P, D, {0.0, 21.0 * MPa}, 0.3); }, "for 4 parameters");
  auto percent = D;
  percent[3] = 61.0;
  expect_refusal([&] { fit_heckel(P, percent, everything); }, "relative density = 61");
  expect_refusal([&] { fit_kawakita(P, D, everything, 0.999); }, "initial density = 0.999");
  expect_refusal([&] { fit_heckel(std::vector(4, 1e6), std::vector(4, 0.5), everything); },
                 "all points are at 1e+06 Pa");
  expect_refusal(
      [&] {
        fit_heckel(std::vector{-1e6, 1e6, 2e6}, std::vector(3, 0.5), {-1e9, 1e9});
      },
      "pressure = -1e+06 Pa");
}

// One density over a narrow range tells nothing of four parameters.
TEST(CompactionCurve, TellsWhenParametersAreNotDetermined) {
  std::vector<double> const P = {100 * MPa, 101 * MPa, 102 * MPa, 103 * MPa, 104 * MPa, 105 * MPa};
  std::vector<double> const D(6, 0.6);
  EXPECT_THROW(fit_cooper_eaton(P, D, everything, 0.35), SolverFailure);
}

} // namespace
