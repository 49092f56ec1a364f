#include "coupling/study/coding.hpp"
#include "coupling/study/design.hpp"
#include "coupling/study/distributions.hpp"
#include "coupling/study/response_surface.hpp"
#include "tests/support/near.hpp"
#include "tests/unit/coupling/study_seed.hpp"
#include "tests/unit/coupling/study_support.hpp"

#include <gtest/gtest.h>

namespace {

using namespace coupling::study;
using namespace study_support;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// y = b0 + b_i x_i + b_ij x_i x_j + b_ii x_i^2 with the coefficients of `b` in the model's order.
VectorXd polynomial(MatrixXd const& coded, VectorXd const& b) {
  return model_matrix(quadratic_terms(static_cast<int>(coded.cols())), coded) * b;
}

ResponseSurface quadratic_fit(Observations data) {
  auto const k = static_cast<int>(data.coded.cols());
  return fit_response_surface(std::move(data), quadratic_terms(k));
}

} // namespace

TEST(Coding, IsThePapersTable4) {
  auto const& [modulus, cohesion] =
      std::pair(study_seed::modulus_of_table7, study_seed::cohesion_of_table7);
  EXPECT_EQ(modulus.to_coded(1375.0), -1.0);
  EXPECT_EQ(modulus.to_coded(2500.0), 0.0);
  EXPECT_EQ(modulus.to_coded(3625.0), 1.0);
  EXPECT_EQ(cohesion.to_coded(7.0), 1.0);
  EXPECT_EQ(modulus.to_natural(0.5), 3062.5);
  EXPECT_NEAR(modulus.to_natural(modulus.to_coded(2250.0)), 2250.0, 1e-12);
  auto const seed = study_seed::observations("table7", "EDEM", "max_force [N]");
  EXPECT_EQ(seed.coded, full_factorial({3, 3}));
  EXPECT_EQ(to_natural(study_seed::factors_of_table7, seed.coded)(8, 0), 3625.0);
}

TEST(Coding, RefusesRangesThatAreNone) {
  MatrixXd const one = MatrixXd::Zero(1, 1);
  EXPECT_EQ(message_of([&] {
              to_coded({{"E", 2.0, 1.0}}, one);
            }),
            "coding: E = 2 to 1 (low must be below high). Are they the wrong way round?");
  EXPECT_EQ(message_of([&] {
              to_coded({{"", 1.0, 2.0}}, one);
            }),
            "coding: factor 1 has no name. What is varied?");
  EXPECT_EQ(message_of([&] {
              to_coded({{"E", 1.0, 2.0}, {"E", 1.0, 2.0}}, one);
            }),
            "coding: E is there twice. Is another factor meant?");
  EXPECT_EQ(message_of([&] {
              to_coded({{"E", 1.0, 2.0}, {"D", 1.0, 2.0}}, one);
            }),
            "coding: has 1 columns for 2 factors. Is a factor missing?");
}

// Quantiles of printed tables (five digits and more).
TEST(Distributions, AreThoseOfTheTables) {
  EXPECT_NEAR(student_quantile(0.95, 3), 3.182446, 1e-6);
  EXPECT_NEAR(student_p(3.182446305, 3), 0.05, 1e-9);
  EXPECT_NEAR(student_p(-3.182446305, 3), 0.05, 1e-9);
  EXPECT_NEAR(fisher_p(9.276628, 3, 3), 0.05, 1e-7);
  EXPECT_NEAR(chi_squared_quantile(0.95, 2), 5.991465, 1e-6); // -2 ln 0.05
  EXPECT_NEAR(chi_squared_p(5.991464547, 2), 0.05, 1e-10);
  EXPECT_NEAR(normal_quantile(0.95), 1.959964, 1e-6);
  EXPECT_EQ(fisher_p(std::numeric_limits<double>::infinity(), 1, 3), 0.0);
  EXPECT_TRUE(std::isnan(student_p(1.0, 0)));
}

TEST(Terms, ComeInGroupsWithTheirParents) {
  auto const names = letters(3);
  std::string all;
  for (auto const& term : quadratic_terms(3))
    all += name_of(term, names) + " ";
  EXPECT_EQ(all, "A B C A*B A*C B*C A^2 B^2 C^2 ");
  EXPECT_EQ(interaction_terms(3).size(), 6u);
  EXPECT_EQ(hierarchical({{2, 2}, {0, 1}, {1}, {2, 2}}),
            (std::vector<Term>{{0}, {1}, {2}, {0, 1}, {2, 2}}));
  VectorXd const x = VectorXd::LinSpaced(3, 2.0, 4.0);
  EXPECT_EQ(value_of({0, 2}, x), 8.0);
  EXPECT_EQ(slope_of({1, 1}, x, 1), 6.0);
  EXPECT_EQ(slope_of({0, 2}, x, 2), 2.0);
  EXPECT_EQ(slope_of({0, 2}, x, 1), 0.0);
}

TEST(ResponseSurface, RecoversAQuadraticExactly) {
  VectorXd b(10);
  b << 28900, 13729, -675, 12, -38, 4, 0.5, 55, -93, 7;
  MatrixXd const coded = central_composite(3, AxialPoints::circumscribed, 1);
  auto const surface = quadratic_fit(observed(coded, polynomial(coded, b)));
  EXPECT_LT((surface.fit.coefficients - b).cwiseAbs().maxCoeff(), 1e-10 * 28900);
  EXPECT_EQ(surface.fit.residual_ss, 0.0); // below its rounding
  EXPECT_EQ(surface.r_squared(), 1.0);
  VectorXd const x = VectorXd::LinSpaced(3, -0.3, 0.9), step = VectorXd::Constant(3, 1e-4);
  EXPECT_NEAR(surface.value(x), polynomial(x.transpose(), b)[0], 1e-8);
  // Central differences of a quadratic are exact.
  EXPECT_NEAR(surface.gradient(x).sum(), (surface.value(x + step) - surface.value(x - step)) / 2e-4,
              1e-4);
}

// y = 1, 2, 4, 5 at x = -1, -1, 1, 1: mean 3, slope 1.5, residuals -+0.5, s^2 = 1 / 2,
// X^T X = 4 I. At x = 1 the leverage is 1/2; t_{0.95}(2) = 4.302653.
TEST(ResponseSurface, HasTheErrorsOfALineByHand) {
  MatrixXd coded(4, 1);
  coded << -1, -1, 1, 1;
  VectorXd y(4);
  y << 1, 2, 4, 5;
  auto const surface = fit_response_surface(observed(coded, y), linear_terms(1));
  auto const slope = surface.coefficients()[1];
  EXPECT_NEAR(slope.value, 1.5, 1e-14);
  EXPECT_NEAR(slope.standard_error, std::sqrt(0.5 / 4.0), 1e-14);
  EXPECT_NEAR(slope.t, 1.5 / std::sqrt(0.125), 1e-13);
  // Two degrees of freedom: p = 1 - t / sqrt(2 + t^2).
  EXPECT_NEAR(slope.p, 1.0 - slope.t / std::sqrt(2.0 + slope.t * slope.t), 1e-12);
  EXPECT_NEAR(slope.upper - slope.value, 4.302652730 * std::sqrt(0.125), 1e-9);
  EXPECT_NEAR(slope.value - slope.lower, 4.302652730 * std::sqrt(0.125), 1e-9);
  EXPECT_NEAR(surface.r_squared(), 0.9, 1e-14);           // TSS 10, RSS 1
  EXPECT_NEAR(surface.adjusted_r_squared(), 0.85, 1e-14); // 1 - (1/2) / (10/3)
  EXPECT_NEAR(surface.fit.press(), 4.0, 1e-13);           // each (0.5 / 0.5)^2
  EXPECT_NEAR(surface.predicted_r_squared(), 0.6, 1e-14);
  auto const at = surface.predict(VectorXd::Constant(1, 1.0));
  EXPECT_NEAR(at.value, 4.5, 1e-14);
  EXPECT_NEAR(at.mean_sd, 0.5, 1e-14);            // sqrt(0.5 * 0.5)
  EXPECT_NEAR(at.run_sd, std::sqrt(0.75), 1e-14); // sqrt(0.5 * 1.5)
  EXPECT_NEAR(at.run_upper - at.value, 4.302652730 * std::sqrt(0.75), 1e-9);
  EXPECT_NEAR(at.value - at.mean_lower, 4.302652730 * 0.5, 1e-9);
  EXPECT_NEAR(surface.fit.covariance()(0, 0), 0.125, 1e-14);
  EXPECT_NEAR(surface.fit.covariance()(0, 1), 0.0, 1e-14);
}

TEST(ResponseSurface, PressIsThatOfRefitsWithoutEachRun) {
  Noise noise(3);
  MatrixXd const coded = latin_hypercube(2, 14, 4);
  VectorXd const y = noise.vector(14);
  double press = 0.0;
  for (int out = 0; out < 14; ++out) {
    std::vector<int> rest;
    for (int k = 0; k < 14; ++k)
      if (k != out)
        rest.push_back(k);
    auto const without = quadratic_fit(observed(coded(rest, Eigen::all), y(rest)));
    press += std::pow(y[out] - without.value(coded.row(out)), 2);
  }
  auto const surface = quadratic_fit(observed(coded, y));
  EXPECT_TRUE(near::relative(surface.fit.press(), press, 1e-12));
  EXPECT_LT(surface.predicted_r_squared(), 0.0) << "noise is not predicted";
}

// Each coefficient of Ramirez-Aragon et al. (2020), equations 2 to 6, to its rounding. The paper
// leaves out the terms that are zero.
TEST(SeedEquations, AreReproducedToEveryPrintedDigit) {
  struct Equation {
    char const *simulator, *column;
    double intercept, E, CED, E_CED, E2, CED2, rounding;
  };
  for (auto const& [simulator, column, intercept, E, CED, E_CED, E2, CED2, rounding] :
       {Equation{"EDEM", "porosity [%]", 41.34556, 1.73833, -2.21167, -0.6625, -0.27833, 0.79167,
                 0.5e-5},
        Equation{"EDEM", "shape_quality [1]", 5.0, -0.33333, 0.5, 0.5, 0.0, -0.5, 0.5e-5},
        Equation{"LIGGGHTS", "max_force [N]", 29026.111, 13763.667, -617.0, -4.5, 23.333, -23.667,
                 0.5e-3},
        Equation{"LIGGGHTS", "porosity [%]", 40.62111, 3.07667, -3.68333, -0.355, -0.50667, 0.87333,
                 0.5e-5},
        Equation{"LIGGGHTS", "shape_quality [1]", 3.77778, -0.83333, 1.16667, 0.0, -0.16667,
                 -0.16667, 0.5e-5}}) {
    auto const surface = quadratic_fit(study_seed::observations("table7", simulator, column));
    VectorXd printed(6);
    printed << intercept, E, CED, E_CED, E2, CED2;
    EXPECT_LT((surface.fit.coefficients - printed).cwiseAbs().maxCoeff(), rounding * (1 + 1e-6))
        << simulator << " " << column << "\n"
        << surface.fit.coefficients;
  }
}

// Equation 1 was fitted to forces that the paper prints in whole newtons. A coefficient is a sum of
// forces times weights w, so half a newton in each moves it by 0.5 sum |w| at most: 0.94 N for the
// intercept, 0.5 N for E, CED and E*CED, 1 N for the squares. Measured: 0.18, 0.02, 0.02, 0.1,
// 0.08, 0.32 N.
TEST(SeedEquations, FirstOneIsWithinWhatWholeNewtonsAllow) {
  auto const surface = quadratic_fit(study_seed::observations("table7", "EDEM", "max_force [N]"));
  VectorXd printed(6);
  printed << 28900.822, 13729.317, -675.683, -38.1, 54.917, -92.683;
  VectorXd const departure = (surface.fit.coefficients - printed).cwiseAbs();
  MatrixXd const weights =
      surface.fit.inverse_information * model_matrix(surface.terms, surface.data.coded).transpose();
  VectorXd const allowed = 0.5 * weights.cwiseAbs().rowwise().sum();
  EXPECT_NEAR(allowed[0], 17.0 / 18.0, 1e-12);
  for (int j = 0; j < 6; ++j) {
    EXPECT_LT(departure[j], allowed[j]) << j;
    EXPECT_LT(departure[j], 0.5) << j;
  }
}

// Section 3.2: R^2 of the forces 1, of the shape qualities close to 0.9.
TEST(SeedEquations, FitAsThePaperSays) {
  auto const r2 = [](char const* simulator, char const* column) {
    return quadratic_fit(study_seed::observations("table7", simulator, column)).r_squared();
  };
  EXPECT_GT(r2("EDEM", "max_force [N]"), 0.99999);
  EXPECT_GT(r2("LIGGGHTS", "max_force [N]"), 0.99999);
  EXPECT_NEAR(r2("EDEM", "porosity [%]"), 0.97888, 1e-5);
  EXPECT_NEAR(r2("LIGGGHTS", "porosity [%]"), 0.97480, 1e-5);
  EXPECT_NEAR(r2("EDEM", "shape_quality [1]"), 11.0 / 12.0, 1e-12);
  EXPECT_NEAR(r2("LIGGGHTS", "shape_quality [1]"), 7.0 / 8.0, 1e-12);
}

// 500 seeded data sets: a new run falls into its 95 % prediction interval, the surface into its
// confidence interval, as often as the binomial distribution allows.
TEST(ResponseSurface, CoversTheTruthAsOftenAsItSays) {
  Noise noise(11);
  MatrixXd const coded = full_factorial({3, 3});
  VectorXd b(6);
  b << 5, 3, -2, 1, 0.5, -0.7;
  VectorXd const x{{0.4, -0.8}};
  double const truth = polynomial(x.transpose(), b)[0], sd = 0.3;
  int run_inside = 0, mean_inside = 0;
  for (int set = 0; set < 500; ++set) {
    VectorXd const y = polynomial(coded, b) + sd * noise.vector(9);
    auto const at = quadratic_fit(observed(coded, y)).predict(x);
    double const new_run = truth + sd * noise();
    run_inside += at.run_lower < new_run && new_run < at.run_upper ? 1 : 0;
    mean_inside += at.mean_lower < truth && truth < at.mean_upper ? 1 : 0;
  }
  RecordProperty("run_inside", run_inside);
  RecordProperty("mean_inside", mean_inside);
  EXPECT_TRUE(is_within_chance(run_inside, 500, 0.95)) << run_inside;
  EXPECT_TRUE(is_within_chance(mean_inside, 500, 0.95)) << mean_inside;
}

TEST(ResponseSurface, WithoutAFreeRunHasNoErrors) {
  MatrixXd const coded = full_factorial({3});
  VectorXd const y{{1.0, 3.0, 2.0}};
  auto const surface = quadratic_fit(observed(coded, y));
  EXPECT_NEAR(surface.value(VectorXd::Constant(1, -1.0)), 1.0, 1e-14);
  EXPECT_TRUE(std::isnan(surface.coefficients()[1].p));
  EXPECT_TRUE(std::isnan(surface.predict(VectorXd::Zero(1)).run_sd));
  EXPECT_TRUE(std::isnan(surface.fit.press()));
}

// All runs shaped as well as can be: no effect, none significant, no fit to speak of.
TEST(ResponseSurface, OfAConstantResponseSeesNoEffects) {
  auto const surface = quadratic_fit(observed(full_factorial({3, 3}), VectorXd::Constant(9, 41.3)));
  EXPECT_TRUE(std::isnan(surface.r_squared()));
  for (auto const& one : surface.coefficients())
    if (one.group != TermGroup::intercept) {
      EXPECT_EQ(one.value, 0.0) << one.name;
      EXPECT_EQ(one.p, 1.0) << one.name;
    }
}
