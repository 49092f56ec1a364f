#include "coupling/study/calibration.hpp"
#include "coupling/study/calibration_misfit.hpp"
#include "coupling/study/design.hpp"
#include "coupling/study/distributions.hpp"
#include "tests/support/near.hpp"
#include "tests/unit/coupling/study_seed.hpp"
#include "tests/unit/coupling/study_support.hpp"

#include <gtest/gtest.h>

namespace {

using namespace coupling::study;
using namespace study_support;
using Eigen::MatrixXd;
using Eigen::VectorXd;

ResponseSurface seed_surface(char const* simulator, char const* column) {
  return fit_response_surface(study_seed::observations("table7", simulator, column),
                              quadratic_terms(2));
}

CalibrationFactor const modulus{study_seed::modulus_of_table7, 1375.0, 3625.0, {}};
CalibrationFactor const cohesion{study_seed::cohesion_of_table7, 3.0, 7.0, {}};

CalibrationFactor held(CalibrationFactor factor, double value) {
  factor.held = value;
  return factor;
}

/// The seed's experiment: 25 095 N, 26.08 %, shape quality 5, with uncertainties of our choice.
CalibrationProblem seed_problem(char const* simulator) {
  return {.factors = {modulus, cohesion},
          .targets = {{seed_surface(simulator, "max_force [N]"), 25095.0, 50.0},
                      {seed_surface(simulator, "porosity [%]"), 26.08, 0.5},
                      {seed_surface(simulator, "shape_quality [1]"), 5.0, 0.5}}};
}

CalibrationFactor coded_factor(char const* name) {
  return {{name, -1.0, 1.0}, -1.0, 1.0, {}};
}

/// Without noise: y = b0 + b . x.
ResponseSurface plane(double b0, VectorXd const& b, std::string name = "y") {
  MatrixXd const coded = full_factorial(std::vector<int>(static_cast<std::size_t>(b.size()), 3));
  return fit_response_surface(observed(coded, (coded * b).array() + b0, std::move(name)),
                              linear_terms(static_cast<int>(b.size())));
}

bool has_statement(Calibration const& found, std::string const& part) {
  return std::ranges::any_of(found.statements, [&](std::string const& one) {
    return one.find(part) != std::string::npos;
  });
}

} // namespace

// Section 3.3 and table 5: at CED = 7e6 J/m^3 the paper sets E = 2250 MPa (EDEM) and 2230 MPa
// (LIGGGHTS) for 25 095 N. Measured: 2250.20 and 2230.85 MPa.
TEST(FactorForTarget, IsTheSeedsCalibratedModulus) {
  for (auto const& [simulator, modulus_of_paper] :
       {std::pair("EDEM", 2250.0), std::pair("LIGGGHTS", 2230.0)}) {
    auto const roots = factor_for_target({modulus, held(cohesion, 7.0)},
                                         {seed_surface(simulator, "max_force [N]"), 25095.0, 0.0});
    ASSERT_EQ(roots.size(), 1u);
    EXPECT_NEAR(roots[0].value, modulus_of_paper, 1.0) << simulator;
    EXPECT_GT(roots[0].sd, 0.5); // 30 N of the surface over 12.2 N/MPa, LIGGGHTS half of it
    EXPECT_LT(roots[0].sd, 4.0);
  }
}

// y = x^2 - 0.25 in coded units, x = E / 10 - 1 natural: roots -0.5 and 0.5.
TEST(FactorForTarget, FindsBothRootsAndTheirErrors) {
  MatrixXd const coded = full_factorial({5});
  VectorXd y = coded.array().square();
  y[0] += 0.1; // residuals, so that the surface has an error
  auto const surface = fit_response_surface(observed(coded, y), quadratic_terms(1));
  CalibrationFactor const factor{{"A", 0.0, 20.0}, 0.0, 20.0, {}};
  auto const roots = factor_for_target({factor}, {surface, 0.25, 0.3});
  ASSERT_EQ(roots.size(), 2u);
  for (auto const& root : roots) {
    VectorXd const x = VectorXd::Constant(1, factor.range.to_coded(root.value));
    EXPECT_NEAR(surface.value(x), 0.25, 1e-13);
    double const sd = std::hypot(0.3, surface.predict(x).mean_sd);
    EXPECT_TRUE(near::relative(root.sd, 10.0 * sd / std::abs(surface.gradient(x)[0]), 1e-12));
  }
  CalibrationFactor upper = factor;
  upper.lowest = 10.0;
  EXPECT_EQ(factor_for_target({upper}, {surface, 0.25, 0.0}).size(), 1u);
  EXPECT_TRUE(factor_for_target({factor}, {surface, 9.0, 0.0}).empty());
  EXPECT_TRUE(factor_for_target({factor}, {surface, -9.0, 0.0}).empty());
}

// Two planes y1 = 3 + x1 + x2 and y2 = 1 + x1 - x2 without error meet 3.3 and 1.5 at x = (0.4,
// -0.1). y1 + y2 and y1 - y2 give x1 and x2 as half sums of independent targets with sd 0.1 and
// 0.2: sd 0.5 sqrt(0.05) = 0.1118 each. Profile: 1.96 sd; joint: sqrt(5.9915) = 2.4477 sd.
TEST(Calibration, SolvesTwoPlanesByHand) {
  CalibrationProblem const problem{
      .factors = {coded_factor("A"), coded_factor("B")},
      .targets = {{plane(3, VectorXd{{1, 1}}), 3.3, 0.1}, {plane(1, VectorXd{{1, -1}}), 1.5, 0.2}}};
  auto const found = calibrate(problem);
  EXPECT_NEAR(found.factors[0].value, 0.4, 1e-8);
  EXPECT_NEAR(found.factors[1].value, -0.1, 1e-8);
  EXPECT_LT(found.chi_squared, 1e-12);
  EXPECT_EQ(found.df, 0);
  EXPECT_TRUE(std::isnan(found.p));
  EXPECT_FALSE(found.contradicts);
  double const sd = 0.5 * std::sqrt(0.05);
  for (auto const& one : found.factors) {
    EXPECT_NEAR(one.upper - one.value, 1.959964 * sd, 1e-6);
    EXPECT_NEAR(one.value - one.lower, 1.959964 * sd, 1e-6);
    EXPECT_NEAR(one.region_upper - one.value, std::sqrt(5.991465) * sd, 1e-6);
    EXPECT_FALSE(one.is_at_bound || one.is_open_low || one.is_open_high);
  }
  EXPECT_NEAR(found.region_threshold - found.chi_squared, 5.991465, 1e-6);
  // y1 is off by 0.1 at (0.5, -0.1): one sd; y2 off by 0.1: half an sd.
  EXPECT_NEAR(chi_squared(problem, {0.5, -0.1}), 1.25, 1e-12);
  EXPECT_EQ(found.statements.size(), 1u) << found.statements.back();
  EXPECT_TRUE(has_statement(found, "As many free factors as targets or more"));
}

// Three planes for one factor: y = x + c with targets 0.1, 0.3, 0.8 (sd 0.1 each, c = 0): the mean
// 0.4, chi^2 = (9 + 1 + 16) = 26 with 2 degrees: p = exp(-13).
TEST(Calibration, SaysThatTargetsContradict) {
  CalibrationProblem problem{.factors = {coded_factor("A")}, .targets = {}};
  for (double const target : {0.1, 0.3, 0.8})
    problem.targets.push_back(
        {plane(0, VectorXd::Ones(1), "y" + std::to_string(problem.targets.size())), target, 0.1});
  auto const found = calibrate(problem);
  EXPECT_NEAR(found.factors[0].value, 0.4, 1e-8);
  EXPECT_NEAR(found.chi_squared, 26.0, 1e-9);
  EXPECT_EQ(found.df, 2);
  EXPECT_NEAR(found.p, std::exp(-13.0), 1e-12);
  EXPECT_TRUE(found.contradicts);
  EXPECT_NEAR(found.targets[2].residual, -4.0, 1e-7);
  EXPECT_NEAR(found.targets[2].residual_alone, 0.0, 1e-8);
  EXPECT_NEAR(found.targets[2].wanted[0], 0.8, 1e-8);
  EXPECT_EQ(found.statements[0], "The targets contradict each other: chi^2 = 26 with 2 degrees of "
                                 "freedom, p = 2.3e-06.");
  EXPECT_EQ(found.statements[3], "y2 is 0.4, 4 sd below its target 0.8; alone it wants A = 0.8.");
}

TEST(Calibration, StatesATargetOutOfReach) {
  CalibrationProblem const problem{.factors = {coded_factor("A")},
                                   .targets = {{plane(5, VectorXd::Ones(1), "P"), 2.0, 0.5}}};
  auto const found = calibrate(problem);
  EXPECT_EQ(found.factors[0].value, -1.0);
  EXPECT_TRUE(found.factors[0].is_at_bound);
  EXPECT_TRUE(found.factors[0].is_open_low);
  EXPECT_FALSE(found.targets[0].is_reachable);
  EXPECT_NEAR(found.targets[0].lowest, 4.0, 1e-13);
  EXPECT_NEAR(found.targets[0].highest, 6.0, 1e-13);
  EXPECT_NEAR(found.targets[0].residual_alone, 4.0, 1e-12);
  EXPECT_TRUE(found.contradicts);
  EXPECT_TRUE(has_statement(
      found, "P = 2 is out of reach: inside the bounds the surface lies between 4 and "
             "6; alone it would stay 4 sd away, at A = -1."));
  EXPECT_TRUE(has_statement(found, "A = -1 is a bound: the targets want to go further."));
  EXPECT_TRUE(has_statement(
      found, "A: the lower end of its 95 % interval is the bound -1, not the targets'."));
}

TEST(Calibration, SaysWhatOneTargetLeavesOpen) {
  CalibrationProblem const problem{.factors = {coded_factor("A"), coded_factor("B")},
                                   .targets = {{plane(0, VectorXd{{1, 1}}), 0.2, 0.1}}};
  auto const found = calibrate(problem);
  EXPECT_LT(found.chi_squared, 1e-12);
  EXPECT_EQ(found.df, -1);
  EXPECT_TRUE(has_statement(found, "B: the upper end of its 95 % interval is the bound 1"));
  EXPECT_TRUE(found.factors[0].is_open_high);
  EXPECT_FALSE(found.factors[0].is_open_low); // A >= 0.2 - 1 - 1.96 sd
  EXPECT_NEAR(found.factors[0].lower, -0.8 - 0.1959964, 1e-6);
  auto const one = calibrate(
      {.factors = {coded_factor("A"), held(coded_factor("B"), 0.5)}, .targets = problem.targets});
  EXPECT_NEAR(one.factors[0].value, -0.3, 1e-9);
  EXPECT_TRUE(one.factors[1].is_held);
  EXPECT_EQ(one.factors[1].value, 0.5);
}

// The paper solves three equations for two factors. Force and shape quality can be met; no factor
// inside the design gives 26.08 % of porosity.
TEST(SeedCalibration, PorosityContradictsTheForce) {
  for (char const* simulator : {"EDEM", "LIGGGHTS"}) {
    auto const found = calibrate(seed_problem(simulator));
    EXPECT_TRUE(found.contradicts);
    EXPECT_LT(found.p, 1e-4);
    EXPECT_FALSE(found.targets[1].is_reachable);
    EXPECT_GT(found.targets[1].lowest, 34.0);
    EXPECT_NEAR(found.targets[0].value, 25095.0, 300.0);
    EXPECT_EQ(found.factors[1].value, 7.0);
    EXPECT_TRUE(found.factors[1].is_at_bound);
    EXPECT_TRUE(has_statement(found, "porosity = 26.08 is out of reach")) << simulator;
    for (auto const& one : found.statements)
      RecordProperty(std::string(simulator) + std::to_string(&one - found.statements.data()), one);
    // Without the porosity the two agree, and the paper's modulus lies in the interval.
    auto problem = seed_problem(simulator);
    problem.targets.erase(problem.targets.begin() + 1);
    problem.factors[1].held = 7.0;
    auto const without = calibrate(problem);
    EXPECT_FALSE(without.contradicts);
    EXPECT_GT(without.p, 0.2);
    EXPECT_NEAR(without.factors[0].value, simulator[0] == 'E' ? 2250.0 : 2230.0, 2.0);
  }
}

// 500 times: surfaces fitted to runs with scatter, targets drawn around the truth. The region of
// two responses for two factors holds the truth in 95 % of them.
TEST(Calibration, RegionCoversTheTruthAsOftenAsItSays) {
  Noise noise(2024);
  MatrixXd const coded = full_factorial({5, 5, 8}).leftCols(2); // 200 runs: s is well known
  VectorXd const truth{{0.3, -0.2}};
  VectorXd b1(6), b2(6);
  b1 << 10, 3, 1, 0.4, 0.3, -0.2;
  b2 << 4, 1, -2, 0.1, -0.3, 0.2;
  auto const terms = quadratic_terms(2);
  MatrixXd const X = model_matrix(terms, coded);
  VectorXd const z = regressors(terms, truth);
  constexpr double run_sd = 0.2, target_sd = 0.1;
  int inside = 0, run_inside = 0, profile_inside = 0, profiled = 0;
  for (int set = 0; set < 500; ++set) {
    auto const target = [&](VectorXd const& b, char const* name, double scatter) {
      auto surface =
          fit_response_surface(observed(coded, X * b + run_sd * noise.vector(200), name), terms);
      return CalibrationTarget{std::move(surface),
                               z.dot(b) + target_sd * noise() + scatter * noise(), target_sd};
    };
    for (auto const spread : {SurfaceSpread::mean, SurfaceSpread::run}) {
      double const scatter = spread == SurfaceSpread::run ? run_sd : 0.0;
      CalibrationProblem const problem{
          .factors = {coded_factor("A"), coded_factor("B")},
          .targets = {target(b1, "y1", scatter), target(b2, "y2", scatter)},
          .spread = spread};
      auto const best = minimise_in(residuals_of(problem), box_of(problem.factors));
      bool const is_in =
          chi_squared(problem, {truth[0], truth[1]}) - best.value <= chi_squared_quantile(0.95, 2);
      (spread == SurfaceSpread::run ? run_inside : inside) += is_in ? 1 : 0;
      if (set % 5 == 0 && spread == SurfaceSpread::mean) {
        auto const found = calibrate(problem);
        ++profiled;
        profile_inside +=
            found.factors[0].lower <= truth[0] && truth[0] <= found.factors[0].upper ? 1 : 0;
      }
    }
  }
  RecordProperty("inside", inside);
  RecordProperty("run_inside", run_inside);
  RecordProperty("profile_inside", profile_inside);
  EXPECT_TRUE(is_within_chance(inside, 500, 0.95)) << inside;
  EXPECT_TRUE(is_within_chance(run_inside, 500, 0.95)) << run_inside;
  EXPECT_TRUE(is_within_chance(profile_inside, profiled, 0.95)) << profile_inside;
}

TEST(Calibration, RefusesWhatCannotBeCalibrated) {
  auto const surface = plane(0, VectorXd::Ones(1), "F");
  auto const message = [](std::vector<CalibrationFactor> factors,
                          std::vector<CalibrationTarget> targets) {
    return message_of([&] { calibrate({std::move(factors), std::move(targets)}); });
  };
  auto const A = coded_factor("A");
  EXPECT_EQ(message({A}, {}),
            "calibration: has no targets (there is nothing to meet). Which results "
            "are known?");
  EXPECT_EQ(message({held(A, 0.0)}, {{surface, 0.0, 1.0}}),
            "calibration: every factor is held (there is nothing to calibrate). Free one?");
  EXPECT_EQ(message({A}, {{surface, 0.0, 0.0}}),
            "calibration: target F has the standard uncertainty 0 and its surface none (residuals "
            "could not be weighed). How well is it known?");
  EXPECT_EQ(message({A}, {{surface, 0.0, -1.0}}),
            "calibration: target F has the standard uncertainty -1 (0 or more). How well is it "
            "known?");
  EXPECT_EQ(message({A}, {{surface, std::nan(""), 1.0}}),
            "calibration: target F = nan (a target is a number). Was it measured?");
  EXPECT_EQ(message({coded_factor("B")}, {{surface, 0.0, 1.0}}),
            "calibration: F was fitted to other factors (all targets share theirs). Is another "
            "surface meant?");
  auto reversed = A;
  std::swap(reversed.lowest, reversed.highest);
  EXPECT_EQ(message({reversed}, {{surface, 0.0, 1.0}}),
            "calibration: A = 1 to -1 (the lower bound must be below the upper). Hold it?");
  EXPECT_EQ(message({held(A, std::nan(""))}, {{surface, 0.0, 1.0}}),
            "calibration: A = nan is held (it must be a number). At which value?");
  EXPECT_EQ(message_of([&] {
              factor_for_target({coded_factor("A"), coded_factor("B")},
                                {plane(0, VectorXd{{1, 1}}), 0.0, 0.0});
            }),
            "factor for a target: 2 factors are free (one equation determines one). Hold all "
            "others?");
}
