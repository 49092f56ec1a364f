// The error model: each term by hand, each tolerance felt, refusals.
#include "coupling/diagnosis/error_model.hpp"
#include "coupling/diagnosis/whitening.hpp"
#include "tests/support/near.hpp"
#include "tests/unit/coupling/diagnosis_linear.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace {

using namespace diagnosis_support;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Two runs with force in loading and unloading, and a height in the first.
Observations five_blocks() {
  VectorXd const up{{0.0, 100.0, 1000.0}}, down{{900.0, 50.0}};
  return Observations(
      {block("a", "force", Phase::loading, up), block("a", "force", Phase::unloading, down),
       block("a", "height", Phase::after, VectorXd{{9e-3}}),
       block("b", "force", Phase::loading, up), block("b", "force", Phase::unloading, down)});
}

std::vector<ChannelError> two_channels() {
  return {
      {.channel = "force", .sd = 10.0, .sd_relative = 0.01, .correlation = 0.5, .has_kink = true},
      {.channel = "height", .sd = 2e-5, .model_share = 0.001}};
}

/// A model of these blocks with all kinds of terms.
LinearModel eleven_rows() {
  LinearModel model = random_linear(3, 11, 1, 2);
  model.offset = five_blocks().values();
  model.repeats = {{"mass", "kg", 0.5}, {"zero", "m", 2.0}};
  model.scattering = normals(9, 11, 2);
  return model;
}

ErrorSources sources() {
  return {.channels = two_channels()};
}

MatrixXd covariance_with(ErrorSources const& given) {
  auto const model = eleven_rows();
  Parameters at = nominal_parameters(model);
  at.sizes[1] = 3.0;
  return error_model(five_blocks(), model, given, at, {1}).covariance;
}

} // namespace

TEST(ErrorTerms, ARowOfManyReadingsIsSurer) {
  ChannelBlock block{.run = "run1", .channel = "force", .phase = Phase::loading};
  block.coordinate = VectorXd::LinSpaced(3, 0.0, 1.0);
  block.values = VectorXd::Constant(3, 100.0);
  block.n_readings = VectorXd{{1.0, 4.0, 25.0}};
  Observations const data({block});
  std::vector<ChannelError> const errors{{.channel = "force", .sd = 10.0}};
  auto const S = sensor_covariance(data, errors_of_blocks(data, errors), data.values());
  EXPECT_DOUBLE_EQ(S(0, 0), 100.0);
  EXPECT_DOUBLE_EQ(S(1, 1), 25.0);
  EXPECT_DOUBLE_EQ(S(2, 2), 4.0);
  block.n_readings = VectorXd::Ones(2);
  EXPECT_THROW(Observations({block}), dem::InvalidInput);
}

TEST(ErrorTerms, SensorIsAutoregressiveInsideABlock) {
  auto const data = five_blocks();
  auto const S = sensor_covariance(data, errors_of_blocks(data, two_channels()), data.values());
  // sd^2 = 10^2 + (0.01 f)^2: f = 100 gives 101, f = 1000 gives 200
  EXPECT_NEAR(S(1, 1), 101.0, 1e-12);
  EXPECT_NEAR(S(2, 2), 200.0, 1e-12);
  EXPECT_NEAR(S(0, 2), 0.25 * std::sqrt(100.0 * 200.0), 1e-12);
  EXPECT_EQ(S(2, 3), 0.0); // another phase
  EXPECT_EQ(S(1, 7), 0.0); // another run
  EXPECT_NEAR(S(5, 5), 4e-10, 1e-24);
}

TEST(ErrorTerms, RepeatsShareTheirScatterInsideARunAndAverage) {
  auto blocks = five_blocks().blocks();
  for (auto& one : blocks)
    one.n_repeats = one.run == "a" ? 4 : 1;
  Observations const data(blocks);
  MatrixXd const changes = normals(4, 11, 2);
  MatrixXd const all = changes * changes.transpose();
  auto const S = repeatability_covariance(data, changes);
  EXPECT_NEAR(S(1, 5), all(1, 5) / 4.0, 1e-14); // force and height of one run
  EXPECT_NEAR(S(7, 9), all(7, 9), 1e-14);
  EXPECT_EQ(S(1, 7), 0.0);
  auto const sensor =
      sensor_covariance(data, errors_of_blocks(data, two_channels()), data.values());
  EXPECT_NEAR(sensor(1, 1), 101.0 / 4.0, 1e-12);
}

TEST(ErrorTerms, NumericalKeepsAShareOfTheBias) {
  VectorXd const bias{{1.0, -2.0}};
  MatrixXd const C{{2.0, 0.5}, {0.5, 1.0}};
  auto const S = numerical_covariance({bias, C}, 0.3, 2);
  EXPECT_NEAR(S(0, 0), 2.09, 1e-15);
  EXPECT_NEAR(S(0, 1), 0.5 - 0.18, 1e-15);
  EXPECT_NEAR(S(1, 1), 1.36, 1e-15);
  EXPECT_EQ(numerical_covariance({}, 0.3, 2), MatrixXd::Zero(2, 2));
}

TEST(ErrorTerms, MaternIsThatOfItsFormula) {
  EXPECT_EQ(matern_3_2(0.0, 0.4), 1.0);
  // sqrt(3) d / l = 1 at d = l / sqrt(3): 2 / e
  EXPECT_NEAR(matern_3_2(0.4 / std::sqrt(3.0), 0.4), 2.0 / std::numbers::e, 1e-15);
  // Once differentiable: 1 - x^2 / 2 near 0, x = sqrt(3) d / l
  double const x = std::sqrt(3.0) * 1e-3 / 0.4;
  EXPECT_NEAR(1.0 - matern_3_2(1e-3, 0.4), 0.5 * x * x, x * x * x);
}

TEST(ErrorTerms, ToleranceIsSmoothInAPhaseAndSharedBetweenRuns) {
  auto const data = five_blocks();
  Tolerances const t;
  auto const of_blocks = errors_of_blocks(data, two_channels());
  VectorXd const sd = tolerance_sd(data, of_blocks, data.values(), t);
  EXPECT_NEAR(sd[2], 3.0, 1e-12);  // 0.3 % of 1000 N
  EXPECT_NEAR(sd[5], 9e-6, 1e-15); // the height's own 0.1 %
  auto const S = smooth_covariance(data, sd, t);
  EXPECT_NEAR(S(1, 2), 0.3 * 3.0 * matern_3_2(0.5, 0.4), 1e-12);
  EXPECT_NEAR(S(2, 8), 0.8 * 9.0, 1e-12); // the same place in the other run
  EXPECT_EQ(S(2, 3), 0.0);
  Eigen::SelfAdjointEigenSolver<MatrixXd> const eigen(S);
  EXPECT_GT(eigen.eigenvalues().minCoeff(), -1e-12);
}

TEST(ErrorTerms, KinksWidenWhereContactBeginsAndEnds) {
  auto const data = five_blocks();
  auto const sd =
      kink_sd(data, errors_of_blocks(data, two_channels()), data.values(), Tolerances{});
  EXPECT_NEAR(sd[0], 4.0, 1e-12);                           // 0.004 of 1000 N
  EXPECT_NEAR(sd[1], 4.0 * std::exp(-100.0 / 12.0), 1e-12); // 0.012 of 1000 N
  EXPECT_NEAR(sd[4], 4.0 * std::exp(-50.0 / 12.0), 1e-12);  // unloading knows the run's largest
  EXPECT_EQ(sd[5], 0.0);
}

TEST(ErrorModel, IsTheSumOfItsTermsAtThePoint) {
  auto const model = eleven_rows();
  auto const data = five_blocks();
  Parameters at = nominal_parameters(model);
  at.sizes[1] = 3.0;
  ErrorSources given = sources();
  given.numerical = {VectorXd::Constant(11, 2.0), 0.1 * MatrixXd::Identity(11, 11)};
  auto const errors = error_model(data, model, given, at, {1});
  auto const of_blocks = errors_of_blocks(data, given.channels);
  VectorXd const f = model.predict(at);
  VectorXd const change = 3.0 * model.effects.col(1);
  MatrixXd const J = model.scattering * VectorXd{{0.5, 2.0}}.asDiagonal();
  MatrixXd expected = sensor_covariance(data, of_blocks, f) + repeatability_covariance(data, J) +
                      numerical_covariance(given.numerical, 0.3, 11) +
                      smooth_covariance(data, tolerance_sd(data, of_blocks, f, {}), {}) +
                      smooth_covariance(data, 0.07 * change.cwiseAbs(), {});
  expected.diagonal() += kink_sd(data, of_blocks, f, {}).cwiseAbs2();
  EXPECT_LT((errors.covariance - expected).norm(), 1e-10 * expected.norm());
  EXPECT_EQ(errors.bias, given.numerical.bias);
  EXPECT_NEAR(errors.shares.form[1], 0.07 * std::abs(change[1]), 1e-9);
}

TEST(ErrorModel, HoldsTheSignaturesOwnErrorsAndWhatCleanDataShow) {
  auto model = eleven_rows();
  model.errors = {MatrixXd(), normals(12, 11, 3)};
  auto const data = five_blocks();
  Parameters at = nominal_parameters(model);
  at.sizes[1] = 3.0;
  ErrorSources given = sources();
  auto const exact = error_model(data, eleven_rows(), given, at, {1}).covariance;
  MatrixXd const added = error_model(data, model, given, at, {1}).covariance - exact;
  EXPECT_LT((added - 9.0 * model.errors[1] * model.errors[1].transpose()).norm(),
            1e-9 * added.norm());
  given.null_sizes = VectorXd{{0.0, 0.2}};
  model.errors.clear();
  MatrixXd const null = error_model(data, model, given, at, {1}).covariance - exact;
  EXPECT_LT((null - 0.04 * model.effects.col(1) * model.effects.col(1).transpose()).norm(),
            1e-9 * null.norm());
}

TEST(ErrorModel, FeelsEveryTolerance) {
  ErrorSources given = sources();
  given.numerical.bias = VectorXd::Constant(11, 2.0);
  MatrixXd const before = covariance_with(given);
  for (double Tolerances::*const one :
       {&Tolerances::model_share, &Tolerances::phase_length, &Tolerances::run_correlation,
        &Tolerances::form_share, &Tolerances::bias_share, &Tolerances::kink_share,
        &Tolerances::kink_decay}) {
    ErrorSources other = given;
    other.tolerances.*one *= 1.1;
    EXPECT_GT((covariance_with(other) - before).norm(), 1e-9 * before.norm());
  }
  auto const said = state(given.tolerances);
  EXPECT_EQ(said.size(), sizeof(Tolerances) / sizeof(double));
  for (auto const& one : said)
    EXPECT_FALSE(one.meaning.empty() || one.source.empty()) << one.name;
}

TEST(Whitener, TurnsTheCovarianceIntoOne) {
  MatrixXd const S = random_covariance(5, 30);
  Whitener const whitener(S, 1e-9);
  EXPECT_EQ(whitener.jitter(), 0.0);
  MatrixXd const half = whitener.whiten(S);
  EXPECT_LT((whitener.whiten(half.transpose()) - MatrixXd::Identity(30, 30)).norm(), 1e-11);
  EXPECT_LT((whitener.unwhiten(half) - S).norm(), 1e-12 * S.norm());
  EXPECT_NEAR(whitener.log_determinant(), std::log(S.determinant()), 1e-10);
}

TEST(Whitener, SaysItsJitterAndRefusesMore) {
  // Rank one, of very different units: correlations of 1 need jitter.
  VectorXd const sd{{1e-5, 1.0, 1e4}};
  MatrixXd const singular = sd * sd.transpose();
  Whitener const whitener(singular, 1e-9);
  EXPECT_GT(whitener.jitter(), 0.0);
  EXPECT_LE(whitener.jitter(), 1e-9);
  MatrixXd indefinite = MatrixXd::Identity(2, 2);
  indefinite(0, 1) = indefinite(1, 0) = 1.5;
  EXPECT_NE(message_of([&] { Whitener(indefinite, 1e-9); }).find("not positive definite"),
            std::string::npos);
  EXPECT_NE(message_of([&] { Whitener(MatrixXd::Zero(2, 2), 1e-9); }).find("variance 0"),
            std::string::npos);
  EXPECT_NE(message_of([&] {
              Whitener(MatrixXd{{1.0, 0.2}, {0.1, 1.0}}, 1e-9);
            }).find("not symmetric"),
            std::string::npos);
}

TEST(ErrorModel, RefusesWhatCannotBeWeighed) {
  auto const data = five_blocks();
  auto const says = [](std::string const& message, std::string const& part) {
    return message.find(part) != std::string::npos ? std::string("said") : message;
  };
  EXPECT_EQ(says(message_of([&] { (void)errors_of_blocks(data, {}); }), "has 0 statements"),
            "said");
  auto channels = two_channels();
  channels[0].sd = channels[0].sd_relative = 0.0;
  EXPECT_EQ(says(message_of([&] { (void)errors_of_blocks(data, channels); }), "uncertainty"),
            "said");
  channels = two_channels();
  channels[0].correlation = 1.0;
  EXPECT_EQ(says(message_of([&] { (void)errors_of_blocks(data, channels); }), "0 to 1"), "said");
  EXPECT_EQ(says(message_of([&] {
                   (void)numerical_covariance({VectorXd::Zero(3), {}}, 0.3, 11);
                 }),
                 "3 biases"),
            "said");
  for (auto const& [tolerances, part] :
       {std::pair(Tolerances{.model_share = -0.1}, "model_share"),
        std::pair(Tolerances{.phase_length = 0.0}, "phase_length"),
        std::pair(Tolerances{.run_correlation = 1.2}, "run_correlation")})
    EXPECT_EQ(says(message_of([&] { validate(tolerances); }), part), "said");
  ErrorSources given = sources();
  given.null_sizes = VectorXd{{1.0}};
  EXPECT_EQ(says(message_of([&] { (void)covariance_with(given); }), "clean data"), "said");
}

TEST(Observations, AreStackedInTheirOrderAndRefused) {
  auto const data = five_blocks();
  EXPECT_EQ(data.size(), 11);
  EXPECT_EQ(data.rows()[2].first, 5);
  EXPECT_EQ(data.values()[5], 9e-3);
  auto const refused = [](auto const& spoil) {
    auto blocks = five_blocks().blocks();
    spoil(blocks);
    return message_of([&] { Observations{blocks}; });
  };
  using Blocks = std::vector<ChannelBlock>;
  EXPECT_NE(refused([](Blocks& b) { b.clear(); }).find("no measured data"), std::string::npos);
  EXPECT_NE(refused([](Blocks& b) { b[1].values.resize(0); }).find("no values"), std::string::npos);
  EXPECT_NE(refused([](Blocks& b) { b[1].values[0] = no_number; }).find("no number"),
            std::string::npos);
  EXPECT_NE(refused([](Blocks& b) { b[0].coordinate[1] = -0.1; }).find("never back"),
            std::string::npos);
  EXPECT_NE(refused([](Blocks& b) { b[0].coordinate.reverseInPlace(); }).find("never back"),
            std::string::npos);
  EXPECT_NE(refused([](Blocks& b) { b[0].coordinate.conservativeResize(2); }).find("2 coordinates"),
            std::string::npos);
  EXPECT_NE(refused([](Blocks& b) { b[3].run = "a"; }).find("given twice"), std::string::npos);
  EXPECT_NE(refused([](Blocks& b) { b[3].n_repeats = 0; }).find("repeats"), std::string::npos);
}
