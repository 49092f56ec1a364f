// The gain on held-out runs, by hand.
#include "coupling/diagnosis/gain.hpp"
#include "coupling/diagnosis/whitening.hpp"
#include "tests/unit/coupling/diagnosis_linear.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace diagnosis_support;

/// Rows of two channels; the errors before are `off`, after 0.1 of that; variances 4 and 1.
HeldOutRun run(std::string name, VectorXd const& off) {
  VectorXd const measured{{100.0, 200.0, 5.0}};
  return {.run = std::move(name),
          .measured = measured,
          .channels = {"force", "force", "height"},
          .before = {measured - off, 4.0 * MatrixXd::Identity(3, 3)},
          .after = {measured - 0.1 * off, MatrixXd::Identity(3, 3)}};
}

} // namespace

TEST(Gain, IsThatOfTheErrorsByChannel) {
  auto const gain =
      measure_gain({run("a", VectorXd{{3.0, 4.0, 2.0}}), run("b", VectorXd{{30.0, 0.0, 0.0}})});
  ASSERT_EQ(gain.channels.size(), 3u);
  EXPECT_EQ(gain.channels[0].channel, "force");
  EXPECT_NEAR(gain.channels[0].before, std::sqrt((9.0 + 16.0 + 900.0) / 4.0), 1e-12);
  EXPECT_NEAR(gain.channels[0].ratio, 0.1, 1e-12);
  EXPECT_EQ(gain.channels[0].coverage, 0.75); // 3 > 1.96 sd of 1
  EXPECT_NEAR(gain.channels[1].after, std::sqrt(0.04 / 2.0), 1e-12);
  EXPECT_EQ(gain.channels[2].channel, "all");
  EXPECT_NEAR(gain.channels[2].before, std::sqrt(929.0 / 4.0 / 6.0), 1e-12); // over sd 2
  EXPECT_TRUE(std::isnan(gain.channels[0].low)); // two runs give no interval
}

TEST(Gain, ScoresDensities) {
  auto const gain =
      measure_gain({run("a", VectorXd{{3.0, 4.0, 2.0}}), run("b", VectorXd{{30.0, 0.0, 0.0}})});
  // -1/2 (chi^2 + ln det): before 29 / 4 + 3 ln 4, after 0.29; and 900 / 4 + 3 ln 4, after 9
  double const a = 0.5 * (29.0 / 4.0 - 0.29 + 3.0 * std::log(4.0));
  double const b = 0.5 * (225.0 - 9.0 + 3.0 * std::log(4.0));
  EXPECT_NEAR(gain.elpd_difference, a + b, 1e-10);
  // Three runs tell how runs scatter: sqrt(3 var) of a, a, b.
  auto const three =
      measure_gain({run("a", VectorXd{{3.0, 4.0, 2.0}}), run("c", VectorXd{{3.0, 4.0, 2.0}}),
                    run("b", VectorXd{{30.0, 0.0, 0.0}})});
  EXPECT_NEAR(three.elpd_error, b - a, 1e-9);
}

/// The long way: the same run pressed again, 4000 times.
TEST(Gain, KnowsWhatItsScoreWouldScatterBy) {
  HeldOutRun one = run("a", VectorXd{{3.0, -1.0, 2.0}});
  one.before.covariance(0, 1) = one.before.covariance(1, 0) = 2.0;
  one.after.covariance(1, 2) = one.after.covariance(2, 1) = -0.6;
  double const stated = measure_gain({one}).elpd_error;
  Whitener const before(one.before.covariance, 1e-9);
  constexpr Index n = 4000;
  MatrixXd const noise = before.unwhiten(normals(7, 3, n));
  VectorXd found(n);
  for (Index k = 0; k < n; ++k) {
    one.measured = one.before.value + noise.col(k);
    found[k] = measure_gain({one}).elpd_difference;
  }
  double const scatter = std::sqrt((found.array() - found.mean()).square().sum() / (n - 1.0));
  EXPECT_NEAR(stated, scatter, 0.08 * scatter); // 5 sd of a scatter of 4000, heavy tails allowed
}

TEST(Gain, HasAnIntervalOverRuns) {
  std::vector<HeldOutRun> runs;
  MatrixXd const off = normals(5, 3, 12), left = normals(6, 3, 12);
  for (Index k = 0; k < 12; ++k) {
    runs.push_back(run("r" + std::to_string(k), 10.0 * off.col(k)));
    runs.back().after.value = runs.back().measured - 3.0 * left.col(k);
  }
  auto const gain = measure_gain(runs);
  auto const& all = gain.channels.back();
  EXPECT_LT(all.low, all.ratio);
  EXPECT_GT(all.high, all.ratio);
  EXPECT_NEAR(all.ratio, 0.3, 0.15); // 36 rows: 4.9 sqrt(2 / 72) of 0.3 is 0.25 at worst
  EXPECT_LT(all.high - all.low, 0.3);
  EXPECT_EQ(all.low, measure_gain(runs).channels.back().low);
  EXPECT_NE(all.low, measure_gain(runs, {.seed = 2}).channels.back().low);
  EXPECT_NE(all.low, measure_gain(runs, {.n_draws = 50}).channels.back().low);
  // A placebo that changes nothing gains nothing.
  for (auto& one : runs)
    one.after = one.before;
  auto const placebo = measure_gain(runs);
  EXPECT_EQ(placebo.channels.back().ratio, 1.0);
  EXPECT_EQ(placebo.elpd_difference, 0.0);
}

TEST(Gain, RefusesWhatDoesNotFit) {
  auto const refused = [](auto const& spoil) {
    std::vector<HeldOutRun> runs{run("a", VectorXd::Ones(3))};
    spoil(runs);
    return message_of([&] { (void)measure_gain(runs); });
  };
  using Runs = std::vector<HeldOutRun>;
  EXPECT_NE(refused([](Runs& r) { r.clear(); }).find("no held-out run"), std::string::npos);
  EXPECT_NE(refused([](Runs& r) { r[0].channels.pop_back(); }).find("2 channels"),
            std::string::npos);
  EXPECT_NE(refused([](Runs& r) { r[0].after.value.resize(2); }).find("2 foretold"),
            std::string::npos);
  EXPECT_NE(refused([](Runs& r) {
              r[0].measured[1] = std::numeric_limits<double>::infinity();
            }).find("no number"),
            std::string::npos);
  EXPECT_NE(refused([](Runs& r) { r[0].after.covariance.setZero(); }).find("variance 0"),
            std::string::npos);
  EXPECT_NE(message_of([] {
              (void)measure_gain({run("a", VectorXd::Ones(3))}, {.n_draws = 0});
            }).find("0 resamplings"),
            std::string::npos);
}
