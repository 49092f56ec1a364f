// Tests of what calibration leaves: their statistics by hand, their p-values on clean data, their
// power, and where they point.
#include "coupling/diagnosis/misfit_tests.hpp"
#include "coupling/diagnosis/series_tests.hpp"
#include "coupling/study/distributions.hpp"
#include "coupling/study/screening.hpp"
#include "tests/unit/coupling/diagnosis_linear.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace {

using namespace diagnosis_support;

/// Two runs of one channel in two phases and a second channel: 10 + 10 + 10 + 10 + 2 rows.
Observations layout(VectorXd const& y) {
  return Observations({block("a", "upper", Phase::loading, y.segment(0, 10)),
                       block("a", "upper", Phase::unloading, y.segment(10, 10)),
                       block("b", "upper", Phase::loading, y.segment(20, 10)),
                       block("b", "lower", Phase::loading, y.segment(30, 10)),
                       block("b", "height", Phase::after, y.segment(40, 2))});
}

/// A linear model of 42 rows under a fixed Sigma, tested on any data.
struct Bench {
  LinearModel model = random_linear(51, 42, 2, 3);
  MatrixXd covariance = random_covariance(52, 42);
  Whitener whitener{covariance, 1e-9};

  MisfitTests test(VectorXd const& y, MisfitSettings const& settings = {.n_draws = 400}) const {
    Comparison const comparison{&model, y, whitener};
    auto const baseline = fit_baseline(comparison);
    return test_misfit(layout(y), comparison, covariance, signature_library(comparison, baseline),
                       settings);
  }
  /// Data with errors from Sigma, parameters from their priors.
  VectorXd clean(std::uint64_t seed) const {
    VectorXd const u = normals(1000 + seed, 44, 1);
    return model.offset + 2.0 * model.slopes * u.head(2) + whitener.unwhiten(u.tail(42));
  }
  /// An effect of any direction that calibration leaves `lambda` standard uncertainties of.
  VectorXd effect(double lambda) const {
    TangentSpace const tangent(2.0 * whitener.whiten(model.slopes));
    VectorXd const v = normals(77, 42, 1);
    return lambda / tangent.project(v).norm() * whitener.unwhiten(v);
  }
};

} // namespace

TEST(SeriesTests, RunsHaveTheMeanAndVarianceOfAllArrangements) {
  // All 126 orders of 4 positive and 5 negative values.
  std::vector<double> signs{-1, -1, -1, -1, -1, 1, 1, 1, 1};
  double sum = 0.0, squares = 0.0, variance = 0.0;
  int n = 0;
  do {
    auto const runs = count_runs(Eigen::Map<VectorXd>(signs.data(), 9));
    sum += runs.excess;
    squares += runs.excess * runs.excess;
    variance = runs.variance;
    ++n;
  } while (std::ranges::next_permutation(signs).found);
  EXPECT_EQ(n, 126);
  EXPECT_NEAR(sum, 0.0, 1e-10);
  EXPECT_NEAR(squares / n, variance, 1e-12);
  // + + - - + has 3 runs, 2 * 3 * 2 / 5 + 1 = 3.4 expected
  EXPECT_NEAR(count_runs(VectorXd{{1.0, 0.0, -1.0, -2.0, 3.0}}).excess, -0.4, 1e-15);
}

TEST(SeriesTests, LjungBoxIsThatOfR) {
  VectorXd const x{{0.3, 0.5, 0.1, -0.2, -0.7, -0.4, -0.9, 0.2, 0.6, 1.1, 0.4, -0.1}};
  // Rscript -e 'Box.test(c(0.3, ..., -0.1), lag = 4, type = "Ljung")$statistic', R 4.2.2
  EXPECT_NEAR(ljung_box(x, 4), 12.5273036984806, 1e-11);
  EXPECT_NEAR(ljung_box(x, 2), 4.47495355997649, 1e-11);
  EXPECT_EQ(ljung_box(VectorXd::Ones(9), 4), 0.0);
}

TEST(NormalDraws, HangOnSeedAndCounterAlone) {
  MatrixXd const few = normal_draws(7, 5, 3), many = normal_draws(7, 5, 2000);
  EXPECT_EQ(few, many.leftCols(3));
  EXPECT_NE(few, normal_draws(8, 5, 3));
  // 10000 numbers: mean within 4.9 / 100, variance within 4.9 sqrt(2) / 100
  EXPECT_NEAR(many.mean(), 0.0, 0.049);
  EXPECT_NEAR(many.squaredNorm() / 1e4, 1.0, 0.07);
  EXPECT_NEAR(many.col(0).dot(many.col(1)), 0.0, 4.9 * std::sqrt(5.0));
}

TEST(NormalDraws, LogarithmOfTheDistributionIsThatOfR) {
  // Rscript -e 'pnorm(c(-3, -31, -40), log.p = TRUE)'
  EXPECT_NEAR(log_normal_cdf(-3.0), -6.60772622151035, 1e-12);
  EXPECT_NEAR(log_normal_cdf(-31.0), -484.853963627179, 1e-8);
  EXPECT_NEAR(log_normal_cdf(-40.0), -804.608442013754, 1e-8);
  EXPECT_NEAR(log_normal_cdf(0.0), std::log(0.5), 1e-15);
}

TEST(Reference, CountsDrawsAndContinuesTheirTail) {
  std::vector<double> draws(99);
  std::iota(draws.begin(), draws.end(), 1.0);
  Reference const even(draws);
  EXPECT_EQ(even.p(95.5), 5.0 / 100.0); // 96, 97, 98, 99 and the value itself
  EXPECT_EQ(even.p(1000.0), 0.01);
  EXPECT_EQ(even.p(0.0), 1.0);
  EXPECT_NEAR(even.mean(), 50.0, 1e-12);
  EXPECT_NEAR(even.sd(), std::sqrt(99.0 * 100.0 / 12.0), 1e-10);
  // 2000 draws of chi^2 with 5 degrees of freedom: the tail is theirs, far beyond 1 / 2001
  MatrixXd const z = normal_draws(3, 5, 2000);
  std::vector<double> squares;
  for (Index k = 0; k < 2000; ++k)
    squares.push_back(z.col(k).squaredNorm());
  Reference const chi(squares);
  EXPECT_EQ(chi.tail_p(5.0), chi.p(5.0));
  double const exact = coupling::study::chi_squared_p(35.0, 5.0); // 1.5e-6
  EXPECT_LT(chi.tail_p(35.0), 5.0 * exact);
  EXPECT_GT(chi.tail_p(35.0), exact / 5.0);
  EXPECT_NE(message_of([] { Reference({1.0}); }).find("1 draws"), std::string::npos);
}

TEST(Misfit, HolmStepsDown) {
  // 4 tests: 0.01 * 4, max(0.02 * 3, 0.04), max(0.03 * 2, 0.06), 0.5
  auto const p = coupling::study::adjust_holm({0.02, 0.5, 0.01, 0.03});
  EXPECT_NEAR(p[2], 0.04, 1e-15);
  EXPECT_NEAR(p[0], 0.06, 1e-15);
  EXPECT_NEAR(p[3], 0.06, 1e-15);
  EXPECT_NEAR(p[1], 0.5, 1e-15);
}

TEST(Misfit, HasUniformPOnCleanData) {
  Bench const bench;
  constexpr int n_sets = 400;
  std::vector<double> omnibus, targeted;
  int alarms = 0, mapped = 0;
  for (int set = 0; set < n_sets; ++set) {
    auto const tests =
        bench.test(bench.clean(static_cast<std::uint64_t>(set)),
                   {.level = 0.05, .n_draws = 400, .seed = static_cast<std::uint64_t>(set)});
    omnibus.push_back(tests.p_omnibus);
    targeted.push_back(tests.p_targeted);
    alarms += tests.is_alarm ? 1 : 0;
    mapped +=
        std::ranges::any_of(tests.cells, [](auto const& c) { return c.p_holm < 0.05; }) ? 1 : 0;
  }
  for (auto* p : {&omnibus, &targeted}) {
    std::ranges::sort(*p);
    double distance = 0.0;
    for (int k = 0; k < n_sets; ++k)
      distance =
          std::max(distance, std::abs((*p)[static_cast<std::size_t>(k)] - (k + 0.5) / n_sets));
    // Kolmogorov: 2 exp(-2 n D^2) = 1e-6 at D = sqrt(ln(2e6) / 2n) = 0.135
    EXPECT_LT(distance, 0.135);
    for (double const level : {0.05, 0.2, 0.5})
      EXPECT_TRUE(is_within_chance(
          static_cast<int>(std::ranges::lower_bound(*p, level) - p->begin()), n_sets, level));
  }
  // Between the larger test alone, 2.5 %, and both independent, 5 %.
  EXPECT_LT(alarms, 0.05 * n_sets + 4.9 * std::sqrt(0.05 * 0.95 * n_sets) + 1.0);
  EXPECT_GT(alarms, 0);
  EXPECT_LT(mapped, 0.05 * n_sets + 4.9 * std::sqrt(0.05 * 0.95 * n_sets) + 1.0);
}

TEST(Misfit, HasThePowerOfTheNoncentralChiSquared) {
  Bench const bench;
  for (double const lambda : {4.0, 6.0, 8.0, 16.0}) {
    constexpr int n_sets = 100;
    int found = 0;
    for (int set = 0; set < n_sets; ++set)
      found +=
          bench.test(bench.clean(5000 + static_cast<std::uint64_t>(set)) + bench.effect(lambda),
                     {.level = 0.01, .n_draws = 400, .seed = static_cast<std::uint64_t>(set)})
                      .p_omnibus < 0.005
              ? 1
              : 0;
    // 42 rows less two calibrated parameters, whose priors are wide against the data
    double const threshold = quantile(complement(boost::math::chi_squared(40.0), 0.005));
    double const power =
        cdf(complement(boost::math::non_central_chi_squared(40.0, lambda * lambda), threshold));
    EXPECT_NEAR(found, n_sets * power, 4.9 * std::sqrt(n_sets * power * (1.0 - power)) + 2.0)
        << lambda;
  }
}

TEST(Misfit, PointsAtTheCellAndTheSign) {
  Bench bench;
  bench.covariance = 0.04 * MatrixXd::Identity(42, 42);
  bench.whitener = Whitener(bench.covariance, 1e-9);
  VectorXd y = bench.clean(3);
  for (Index k = 0; k < 10; ++k) // unloading of run a, rising from -1 to 1
    y[10 + k] += 2.0 * static_cast<double>(k) / 9.0 - 1.0;
  auto const tests = bench.test(y);
  EXPECT_TRUE(tests.is_alarm);
  ASSERT_EQ(tests.cells.size(), 4u); // upper loading, upper unloading, lower loading, height
  auto const& worst = *std::ranges::min_element(tests.cells, {}, &CellMisfit::p_holm);
  EXPECT_EQ(worst.channel, "upper");
  EXPECT_EQ(worst.phase, Phase::unloading);
  EXPECT_EQ(worst.shape, "measured rises against the model");
  EXPECT_GT(worst.size, 5.0);
  EXPECT_LT(worst.p_holm, 1e-4);
}

TEST(Misfit, SeesTheRunThatIsOff) {
  Bench bench;
  bench.covariance = 0.04 * MatrixXd::Identity(42, 42);
  bench.whitener = Whitener(bench.covariance, 1e-9);
  VectorXd y = bench.clean(4);
  y.segment(30, 10).array() -= 0.5;
  auto const tests = bench.test(y);
  ASSERT_EQ(tests.offsets.size(), 4u);
  auto const& worst = *std::ranges::min_element(tests.offsets, {}, &RunOffset::p_holm);
  EXPECT_EQ(worst.run + worst.channel, "blower");
  EXPECT_LT(worst.size, -4.0);
  EXPECT_LT(worst.p_holm, 0.01);
}

TEST(Misfit, TargetsTheMechanismThatIsThere) {
  Bench const bench;
  auto const tests = bench.test(bench.clean(5) + 6.0 * bench.model.effects.col(2));
  EXPECT_EQ(tests.best_mechanism, 2);
  EXPECT_TRUE(tests.is_alarm);
  EXPECT_EQ(tests.p_targeted, 1.0 / 401.0);
  EXPECT_NEAR(tests.expected, 40.0, 2.5); // 400 draws: 4.9 sqrt(80 / 400) = 2.2
}

TEST(Misfit, IsTheSameForTheSameSeedAndRefusesTooFewDraws) {
  Bench const bench;
  VectorXd const y = bench.clean(6);
  EXPECT_EQ(bench.test(y).p_omnibus, bench.test(y).p_omnibus);
  EXPECT_NE(bench.test(y).expected, bench.test(y, {.n_draws = 400, .seed = 2}).expected);
  EXPECT_NE(message_of([&] { (void)bench.test(y, {.n_draws = 399}); }).find("399 draws"),
            std::string::npos);
  EXPECT_NE(message_of([&] { (void)bench.test(y, {.level = 1.0}); }).find("no probability"),
            std::string::npos);
}
