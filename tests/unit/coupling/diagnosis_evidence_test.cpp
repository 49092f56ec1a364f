// Signatures, evidence and intervals against closed forms of linear Gaussian models and quadrature.
#include "coupling/diagnosis/selection.hpp"
#include "coupling/diagnosis/size_interval.hpp"
#include "tests/support/near.hpp"
#include "tests/unit/coupling/diagnosis_linear.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <numbers>

namespace {

using namespace diagnosis_support;

struct Bench {
  LinearModel model;
  MatrixXd covariance;
  Comparison comparison;

  Bench(LinearModel given, std::uint64_t seed, double noise = 1.0)
      : model(std::move(given)), covariance(random_covariance(1000 * seed, model.offset.size())),
        comparison{&model, {}, Whitener(covariance, 1e-9)} {
    auto const n = model.offset.size();
    comparison.target =
        model.offset + noise * comparison.whitener.unwhiten(normals(1000 * seed + 1, n, 1));
  }
  Bench(Bench const&) = delete;

  Fit fit(std::vector<int> const& active) const {
    auto const n = model.slopes.cols() + static_cast<Index>(active.size());
    return fit_hypothesis(comparison, active, VectorXd::Constant(n, 0.1), {.least_fall = 1e-12});
  }
  /// ln N(y; offset, Sigma + X X'), X the slopes of calibrated (sd 2) and active (scale 1.5).
  double log_marginal(std::vector<int> const& active) const {
    MatrixXd C = covariance + 4.0 * model.slopes * model.slopes.transpose();
    for (int const j : active)
      C += 2.25 * model.effects.col(j) * model.effects.col(j).transpose();
    VectorXd const r = comparison.target - model.offset;
    Eigen::LDLT<MatrixXd> const factor(C);
    return -0.5 * (r.dot(factor.solve(r)) + factor.vectorD().array().log().sum());
  }
};

/// ln of the integral over u of exp(-objective / 2) with theta integrated exactly by its Gaussian,
/// for one mechanism with any prior, by Simpson's rule.
double log_quadrature(Bench const& bench, auto const& prior_density, double from, double to) {
  MatrixXd const C = bench.covariance + 4.0 * bench.model.slopes * bench.model.slopes.transpose();
  Eigen::LDLT<MatrixXd> const factor(C);
  VectorXd const r = bench.comparison.target - bench.model.offset;
  VectorXd const v = 1.5 * bench.model.effects.col(0);
  double const rr = r.dot(factor.solve(r)), rv = r.dot(factor.solve(v)),
               vv = v.dot(factor.solve(v));
  double const top = rv / vv, best = -0.5 * (rr - rv * top);
  constexpr int n = 20000;
  double sum = 0.0;
  for (int k = 0; k <= n; ++k) {
    double const u = from + (to - from) * k / n;
    double const weight = k == 0 || k == n ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
    sum += weight * prior_density(u) * std::exp(-0.5 * (rr - 2.0 * u * rv + u * u * vv) - best);
  }
  return best - 0.5 * factor.vectorD().array().log().sum() +
         std::log(sum * (to - from) / (3.0 * n));
}

double normal_density(double u) {
  return std::exp(-0.5 * u * u) / std::sqrt(2.0 * std::numbers::pi);
}

} // namespace

TEST(Signatures, AreWhatCalibrationCannotAbsorb) {
  Bench const bench(random_linear(61, 20, 2, 3), 62);
  auto const library = signature_library(bench.comparison, bench.fit({}));
  MatrixXd const C = bench.covariance + 4.0 * bench.model.slopes * bench.model.slopes.transpose();
  MatrixXd const inner = bench.model.effects.transpose() * C.ldlt().solve(bench.model.effects);
  for (int j = 0; j < 3; ++j) {
    auto const& one = library.signatures[static_cast<std::size_t>(j)];
    EXPECT_TRUE(near::relative(one.detectability(), 1.5 * std::sqrt(inner(j, j)), 1e-8));
    EXPECT_TRUE(near::relative(one.smallest_detectable(), 5.0 / std::sqrt(inner(j, j)), 1e-8));
    EXPECT_NEAR(library.cosines()(j, 0), inner(j, 0) / std::sqrt(inner(j, j) * inner(0, 0)), 1e-8);
    EXPECT_EQ(one.relative_error, 0.0);
  }
  // |P [r ; -u]|^2 of the baseline is its least objective.
  EXPECT_NEAR(library.residual.squaredNorm(), bench.fit({}).objective(), 1e-6);
}

TEST(Signatures, KnowTheirOwnErrorAndTheirShapes) {
  auto model = random_linear(61, 20, 1, 2);
  model.errors = {MatrixXd(), 0.1 * normals(63, 20, 2)};
  model.causes[0].shapes = {{.name = "power", .unit = "", .mean = 1.0, .sd = 0.3}};
  Bench const bench(model, 62);
  auto const library = signature_library(bench.comparison, bench.fit({}));
  EXPECT_EQ(library.signatures[0].whitened.cols(), 3);
  EXPECT_EQ(library.signatures[1].whitened.cols(), 1);
  EXPECT_TRUE(near::relative(library.signatures[1].relative_error,
                             bench.comparison.whitener.whiten(model.errors[1]).norm() /
                                 bench.comparison.whitener.whiten(model.effects.col(1)).norm(),
                             1e-9));
  LinearModel unseen = random_linear(61, 20, 1, 1);
  unseen.effects.setZero();
  Bench const blind(unseen, 62);
  EXPECT_EQ(signature_library(blind.comparison, blind.fit({})).signatures[0].smallest_detectable(),
            no_bound);
}

TEST(Signatures, ScoreIsTheExactBayesFactor) {
  for (bool const is_one_sided : {false, true})
    for (std::uint64_t seed = 70; seed < 76; ++seed) {
      auto model = random_linear(seed, 20, 2, 1);
      model.causes[0].is_one_sided = is_one_sided;
      Bench const bench(model, seed + 100);
      auto const library = signature_library(bench.comparison, bench.fit({}));
      double const exact =
          is_one_sided ? log_quadrature(
                             bench, [](double u) { return 2.0 * normal_density(u); }, 0.0, 8.0)
                       : bench.log_marginal({0});
      EXPECT_NEAR(score_of(library.signatures[0], library.residual).value,
                  2.0 * (exact - bench.log_marginal({})), 1e-5)
          << seed;
    }
}

TEST(Evidence, OfALinearModelIsTheGaussianIntegral) {
  Bench const bench(random_linear(81, 20, 2, 3), 82);
  double const shared = log_evidence(bench.comparison, bench.fit({})) - bench.log_marginal({});
  for (std::vector<int> const& active :
       {std::vector{0}, std::vector{2}, std::vector{0, 1}, std::vector{2, 1, 0}})
    EXPECT_NEAR(log_evidence(bench.comparison, bench.fit(active)) - shared,
                bench.log_marginal(active), 1e-6);
}

TEST(Evidence, OfAOneSidedSizeIsTheQuadratureInsideAndAtZero) {
  int at_zero = 0;
  for (std::uint64_t seed = 90; seed < 102; ++seed) {
    auto model = random_linear(seed, 20, 2, 1);
    model.causes[0].is_one_sided = true;
    Bench const bench(model, seed + 100);
    auto const fit = bench.fit({0});
    at_zero += fit.at.sizes[0] == 0.0 ? 1 : 0;
    double const exact = log_quadrature(
        bench, [](double u) { return 2.0 * normal_density(u); }, 0.0, 8.0);
    EXPECT_NEAR(log_evidence(bench.comparison, fit) - log_evidence(bench.comparison, bench.fit({})),
                exact - bench.log_marginal({}), 1e-5)
        << seed;
  }
  EXPECT_GT(at_zero, 2); // both cases were there
  EXPECT_LT(at_zero, 10);
}

TEST(Evidence, OfAHeavyTailIsCloseToTheQuadrature) {
  for (double const strength : {1.0, 4.0, 12.0}) {
    auto model = random_linear(111, 20, 2, 1);
    model.causes[0].tail = SizeTail::student;
    Bench bench(model, 112);
    bench.comparison.target += strength * model.effects.col(0);
    double const exact = log_quadrature(
        bench, [](double u) { return 0.375 * std::pow(1.0 + 0.25 * u * u, -2.5); }, -30.0, 30.0);
    EXPECT_NEAR(log_evidence(bench.comparison, bench.fit({0})) -
                    log_evidence(bench.comparison, bench.fit({})),
                exact - bench.log_marginal({}), 0.05);
  }
  // It matters: at 8 scales a normal prior costs 8^2 / 2 = 32, the heavy tail some 5 ln(17) / 2
  // = 7.
}

TEST(SizeInterval, OfALinearModelIsThatOfLeastSquares) {
  for (double const tempering : {1.0, 2.0}) {
    Bench bench(random_linear(121, 20, 2, 2), 122);
    bench.comparison.target += 3.0 * bench.model.effects.col(1);
    MatrixXd const C = bench.covariance + 4.0 * bench.model.slopes * bench.model.slopes.transpose();
    VectorXd const v = bench.model.effects.col(1);
    VectorXd const weighed = C.ldlt().solve(v);
    double const sd = 1.0 / std::sqrt(v.dot(weighed));
    double const a = weighed.dot(bench.comparison.target - bench.model.offset) * sd * sd;
    auto const interval = size_interval(bench.comparison, bench.fit({1}), 1, tempering);
    double const half = std::sqrt(3.84 * tempering) * sd;
    EXPECT_NEAR(interval.value, a, 2e-3 * sd);
    EXPECT_NEAR(interval.low, a - half, 3e-3 * sd);
    EXPECT_NEAR(interval.high, a + half, 3e-3 * sd);
    EXPECT_FALSE(interval.is_open_low || interval.is_open_high);
  }
}

TEST(SizeInterval, IsOpenWhereTheDataSayNothing) {
  auto model = random_linear(131, 20, 1, 1);
  model.effects *= 1e-3;
  model.causes[0].is_one_sided = true;
  model.causes[0].high = 7.0;
  Bench const bench(model, 132);
  auto const interval = size_interval(bench.comparison, bench.fit({0}), 0, 1.0);
  EXPECT_TRUE(interval.is_open_low);
  EXPECT_TRUE(interval.is_open_high);
  EXPECT_EQ(interval.low, 0.0);
  EXPECT_EQ(interval.high, 7.0);
  EXPECT_NE(message_of([&] {
              (void)size_interval(bench.comparison, bench.fit({}), 0, 1.0);
            }).find("not active"),
            std::string::npos);
}

TEST(Selection, WeighsByEvidenceAndPriorAndSumsToOne) {
  Bench bench(random_linear(141, 30, 2, 5), 142);
  bench.comparison.target += 2.0 * bench.model.effects.col(3);
  auto const baseline = bench.fit({});
  auto const library = signature_library(bench.comparison, baseline);
  auto selection = select_causes(bench.comparison, baseline, library, 28.0, 7.5, {});
  EXPECT_EQ(selection.best().fit.active, std::vector{3});
  double sum = 0.0;
  int n_singles = 0;
  for (auto const& one : selection.hypotheses) {
    sum += one.probability;
    n_singles += one.fit.active.size() == 1 ? 1 : 0;
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_EQ(n_singles, 5);
  EXPECT_GT(selection.inclusion[3], 0.95);
  // Against none the odds are those of the exact marginal densities times 0.4 / 5 over 0.5.
  auto const& none = *std::ranges::find_if(selection.hypotheses,
                                           [](auto const& h) { return h.fit.active.empty(); });
  EXPECT_NEAR(std::log(selection.best().probability / none.probability),
              (bench.log_marginal({3}) - bench.log_marginal({})) / selection.tempering +
                  std::log(0.08 / 0.5),
              1e-3);
  // Pairs: 0.1 over the 10 that there are.
  auto const& pair = *std::ranges::find_if(selection.hypotheses,
                                           [](auto const& h) { return h.fit.active.size() == 2; });
  EXPECT_NEAR(pair.log_prior, std::log(0.01), 1e-12);
  // Where the best is twice what was expected, log evidences count half.
  double least = 1e300;
  for (auto const& one : selection.hypotheses)
    least = std::min(least, one.fit.chi_squared);
  weigh(selection, 0.5 * least, {}, 5);
  EXPECT_NEAR(selection.tempering, 2.0, 1e-12);
}

TEST(Selection, FindsTwoAndThreeCausesAndFeelsItsSettings) {
  Bench bench(random_linear(151, 40, 2, 8), 152);
  bench.comparison.target += 4.0 * bench.model.effects.col(1) - 3.0 * bench.model.effects.col(6);
  auto const baseline = bench.fit({});
  auto const library = signature_library(bench.comparison, baseline);
  auto const sorted = [](std::vector<int> active) {
    std::ranges::sort(active);
    return active;
  };
  auto const two = select_causes(bench.comparison, baseline, library, 38.0, 8.7, {});
  EXPECT_EQ(sorted(two.best().fit.active), (std::vector{1, 6}));
  auto const count = [](Selection const& s, std::size_t size) {
    return std::ranges::count_if(s.hypotheses,
                                 [&](auto const& h) { return h.fit.active.size() == size; });
  };
  EXPECT_EQ(count(two, 3), 0); // pairs have not failed
  EXPECT_EQ(count(two, 1), 8); // chi^2 is huge
  auto const fewer =
      select_causes(bench.comparison, baseline, library, 38.0, 8.7,
                    {.n_screened = 2, .huge_share = 1e9, .n_bases = 1, .n_partners = 2});
  EXPECT_EQ(count(fewer, 1), 2);
  EXPECT_GE(count(fewer, 2), 2); // of the base, and what its best partner adds
  EXPECT_LE(count(fewer, 2), 4);
  EXPECT_GT(
      count(select_causes(bench.comparison, baseline, library, 38.0, 8.7, {.failing_sds = -100.0}),
            3),
      0);
  // 0.1 over the 28 pairs, or what is said instead.
  EXPECT_NEAR(two.best().log_prior, std::log(0.1 / 28.0), 1e-12);
  EXPECT_NEAR(select_causes(bench.comparison, baseline, library, 38.0, 8.7,
                            {.prior_shares = {0.5, 0.3, 0.2, 0.02}})
                  .best()
                  .log_prior,
              std::log(0.2 / 28.0), 1e-12);
  bench.comparison.target += 5.0 * bench.model.effects.col(4);
  auto const base = bench.fit({});
  auto const three = select_causes(bench.comparison, base,
                                   signature_library(bench.comparison, base), 38.0, 8.7, {});
  EXPECT_EQ(sorted(three.best().fit.active), (std::vector{1, 4, 6}));
}

/// Three causes that do a little of what both true ones do together are the best alone, and pairs
/// are built on them; only a partner's own partners hold the truth.
TEST(Selection, FindsAPairOfWhichNeitherIsGoodAlone) {
  auto model = random_linear(161, 40, 2, 5);
  MatrixXd const both = model.effects.leftCols(2);
  for (Index k = 2; k < 5; ++k)
    model.effects.col(k) = both.col(0) + both.col(1) + 0.4 * model.effects.col(k);
  Bench bench(model, 162);
  bench.comparison.target += 3.0 * both.col(0) + 2.0 * both.col(1);
  auto const baseline = bench.fit({});
  auto const library = signature_library(bench.comparison, baseline);
  auto const found = select_causes(bench.comparison, baseline, library, 38.0, 8.7, {});
  std::vector<int> singles;
  for (auto const& one : found.hypotheses)
    if (one.fit.active.size() == 1)
      singles.push_back(one.fit.active.front());
  ASSERT_EQ(singles.size(), 5u);
  singles.resize(3); // the most probable first
  std::ranges::sort(singles);
  ASSERT_EQ(singles, (std::vector{2, 3, 4}));
  auto best = found.best().fit.active;
  std::ranges::sort(best);
  EXPECT_EQ(best, (std::vector{0, 1}));
}
