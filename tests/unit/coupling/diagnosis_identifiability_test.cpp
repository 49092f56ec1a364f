// What can be told apart, and which measurement would: plane geometry.
#include "coupling/diagnosis/next_measurement.hpp"
#include "tests/support/near.hpp"
#include "tests/unit/coupling/diagnosis_linear.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace {

using namespace diagnosis_support;

/// Three rows with unit errors, no calibrated parameter; effects as given, scales 1.
struct Plane {
  LinearModel model;
  Comparison comparison;
  Fit baseline;
  SignatureLibrary library;

  static LinearModel made(MatrixXd const& effects, MatrixXd const& slopes) {
    LinearModel model;
    model.offset = VectorXd::Zero(effects.rows());
    model.effects = effects;
    model.slopes = slopes;
    for (Index p = 0; p < slopes.cols(); ++p)
      model.parameters.push_back({.name = "theta", .unit = "", .mean = 0.0, .sd = 1.0});
    for (Index j = 0; j < effects.cols(); ++j)
      model.causes.push_back({.name = "c" + std::to_string(j), .unit = "", .scale = 1.0});
    return model;
  }
  explicit Plane(MatrixXd const& effects, MatrixXd const& slopes = MatrixXd(3, 0))
      : model(made(effects, slopes)), comparison{&model, VectorXd::Zero(3),
                                                 Whitener(MatrixXd::Identity(3, 3), 1e-9)},
        baseline(fit_baseline(comparison)), library(signature_library(comparison, baseline)) {}
  Plane(Plane const&) = delete;
};

} // namespace

TEST(Identifiability, SeparationIsTheDistanceToTheRivalsLine) {
  // c0 along x with 10 units, c1 at 30 degrees: 10 sin 30 = 5.
  Plane const plane(MatrixXd{{10.0, 4.0 * std::sqrt(3.0)}, {0.0, 4.0}, {0.0, 0.0}});
  EXPECT_NEAR(separations(plane.library, VectorXd{{1.0, 1.0}})(0, 1), 5.0, 1e-9);
  // At size 10 the rival needs b = 100 cos 30 / 8 = 10.8 scales, but has 3: |(100 - 20.8, 12)|.
  EXPECT_NEAR(separations(plane.library, VectorXd{{10.0, 1.0}})(0, 1),
              std::hypot(100.0 - 12.0 * std::sqrt(3.0), 12.0), 1e-8);
  EXPECT_EQ(separations(plane.library, VectorXd{{1.0, 1.0}})(0, 0), no_bound);
}

TEST(Identifiability, OneSidedRivalsAndShapesCount) {
  Plane const plane(MatrixXd{{10.0, -8.0}, {0.0, 0.0}, {0.0, 0.0}});
  auto rival = plane.library.signatures[1];
  VectorXd const effect = plane.library.signatures[0].projected.col(0);
  EXPECT_NEAR(separation(effect, rival), 0.0, 1e-9); // b = -1.25
  rival.is_one_sided = true;
  EXPECT_NEAR(separation(effect, rival), 10.0, 1e-9);
  rival.projected.conservativeResize(3, 2);
  rival.projected.col(1) = VectorXd{{8.0, 6.0, 0.0}}; // another shape: cos = 0.8, sin = 0.6
  EXPECT_NEAR(separation(effect, rival), 6.0, 1e-9);
}

TEST(Identifiability, CalibrationTakesItsPartAway) {
  // theta along x with a prior of sd 1: what is left of (10, 3) is 10 / sqrt(101) = 0.995 and 3.
  Plane const plane(MatrixXd{{10.0}, {3.0}, {0.0}}, MatrixXd{{10.0}, {0.0}, {0.0}});
  EXPECT_NEAR(plane.library.signatures[0].detectability(), std::sqrt(100.0 / 101.0 + 9.0), 1e-8);
}

TEST(Identifiability, GroupsAreConnectedComponents) {
  MatrixXd apart = MatrixXd::Constant(5, 5, 10.0);
  apart(0, 3) = 3.9; // one direction suffices
  apart(3, 4) = apart(4, 3) = 1.0;
  auto const groups = confounded_groups(apart);
  EXPECT_EQ(groups, (std::vector<std::vector<int>>{{0, 3, 4}, {1}, {2}}));
  EXPECT_EQ(confounded_groups(apart, 2.0).size(), 4u);
}

TEST(Identifiability, CollinearityIndexIsThatOfTheCosine) {
  // Two directions at 30 degrees: eigenvalues 1 +- cos 30.
  Plane const plane(MatrixXd{{10.0, std::sqrt(3.0), 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 0.0}});
  EXPECT_TRUE(near::relative(collinearity_index(plane.library, {0, 1}),
                             1.0 / std::sqrt(1.0 - std::sqrt(0.75)), 1e-8));
  EXPECT_EQ(collinearity_index(plane.library, {0, 2}), no_bound);
}

TEST(NextMeasurement, IsTheOneThatSeparatesByItsCost) {
  // Two causes do the same to three rows.
  Plane const plane(MatrixXd{{10.0, 10.0}, {0.0, 0.0}, {0.0, 0.0}}, MatrixXd{{0.0}, {1.0}, {0.0}});
  std::vector<PossibleCause> possible;
  for (int const j : {0, 1}) {
    Comparison data = plane.comparison;
    data.target = VectorXd{{10.1, 0.0, 0.0}}; // 100 / 101 of 10.1: size 1
    possible.push_back({j, fit_hypothesis(data, {j}, VectorXd::Zero(2))});
  }
  auto const candidate = [](std::string name, double cost, double first, double second) {
    return CandidateMeasurement{.name = std::move(name),
                                .cost = cost,
                                .places = {{.channel = "punch_gap", .unit = "m"}},
                                .baseline = VectorXd{{2.0}},
                                .calibrated = MatrixXd{{0.3}},
                                .effects = MatrixXd{{first, second}},
                                .covariance = MatrixXd{{0.04}}};
  };
  auto const advice =
      next_measurements(plane.baseline, plane.library, possible,
                        {candidate("free but blind", 0.001, 1.0, 1.0),
                         candidate("dear", 10.0, 4.0, 0.0), candidate("apt", 1.0, 2.0, 0.0)});
  ASSERT_EQ(advice.size(), 3u);
  EXPECT_EQ(advice[0].name, "apt");
  EXPECT_EQ(advice[1].name, "dear");
  EXPECT_FALSE(advice[2].is_enough);
  EXPECT_NEAR(advice[2].before, 0.0, 1e-6);
  // Row (10, 2 / 0.2 / sqrt(1 + ..)) against (10, 0): the row is whitened by 0.2 and shares theta,
  // whose slope there, 1.5, and in row 2, 1, with the prior 1 leave 10^2 (1 - 1.5^2 / (1 + 1 +
  // 1.5^2)) = 47.06 of its square; b = 100 / 100 leaves all of it, from the other side
  // b = 100 / 147.06 leaves 100 - 100^2 / 147.06 = 32.0.
  EXPECT_NEAR(advice[0].after, std::sqrt(100.0 - 1e4 / (100.0 + 100.0 * 2.0 / 4.25)), 1e-3);
  EXPECT_NEAR(advice[0].outcomes[0].value[0], 4.0, 1e-2); // 2 + 2 times size 1
  EXPECT_NEAR(advice[0].outcomes[1].value[0], 2.0, 1e-2);
  EXPECT_NEAR(advice[0].outcomes[0].sd[0], 0.2, 1e-12);
}

/// The long way: all rows under one covariance, |e - b r| in its inverse at the best b.
TEST(NextMeasurement, KnowsErrorsThatTheMeasuredRowsShare) {
  Plane const plane(MatrixXd{{10.0, 10.0}, {0.0, 1.0}, {0.0, 0.0}});
  std::vector<PossibleCause> possible;
  for (int const j : {0, 1}) {
    Comparison data = plane.comparison;
    data.target = VectorXd{{10.1, 0.0, 0.0}};
    possible.push_back({j, fit_hypothesis(data, {j}, VectorXd::Zero(1))});
  }
  CandidateMeasurement extra{.name = "another run",
                             .cost = 1.0,
                             .places = {{.channel = "upper_punch_force", .unit = "N"}},
                             .baseline = VectorXd{{0.0}},
                             .calibrated = MatrixXd(1, 0),
                             .effects = MatrixXd{{2.0, 1.6}},
                             .covariance = MatrixXd{{0.04}}};
  auto const after = [&](MatrixXd const& shared) {
    extra.shared = shared;
    return next_measurements(plane.baseline, plane.library, possible, {extra})[0].after;
  };
  auto const slow = [&](VectorXd const& shared) {
    MatrixXd all = MatrixXd::Identity(4, 4);
    all(3, 3) = 0.04;
    all.topRightCorner(3, 1) = shared;
    all.bottomLeftCorner(1, 3) = shared.transpose();
    MatrixXd const S = all.inverse();
    MatrixXd const rows{{10.0, 10.0}, {0.0, 1.0}, {0.0, 0.0}, {2.0, 1.6}};
    double least = no_bound;
    for (int const j : {0, 1}) {
      VectorXd const e = possible[static_cast<std::size_t>(j)].fit.at.sizes[j] * rows.col(j);
      VectorXd const r = rows.col(1 - j);
      least = std::min(least, e.dot(S * e) - std::pow(e.dot(S * r), 2) / r.dot(S * r));
    }
    return std::sqrt(least);
  };
  for (auto const& shared :
       {VectorXd{{0.0, 0.0, 0.0}}, VectorXd{{0.15, 0.0, 0.0}}, VectorXd{{-0.1, 0.12, 0.0}}})
    EXPECT_NEAR(after(shared), slow(shared), 1e-6);
  EXPECT_EQ(after({}), after(MatrixXd::Zero(3, 1)));
}

TEST(NextMeasurement, ForetellsEachChannelWhereTheCausesDifferMost) {
  Plane const plane(MatrixXd{{10.0, 10.0}, {0.0, 0.0}, {0.0, 0.0}});
  std::vector<PossibleCause> possible;
  for (int const j : {0, 1}) {
    Comparison data = plane.comparison;
    data.target = VectorXd{{10.0 + 1.0 / 10.0, 0.0, 0.0}}; // size 1 with its prior
    possible.push_back({j, fit_hypothesis(data, {j}, VectorXd::Zero(1))});
  }
  // Force in two phases, pressure between them. Standardised differences: 3 / 1, 8 / 4, 5 / 1 in
  // the force, so its last row; 2e5 / 1e5, 6e5 / 1e5 in the pressure.
  auto const at = [](char const* channel, char const* unit, Phase phase, double gap) {
    return ReadingPlace{.channel = channel, .unit = unit, .phase = phase, .gap = gap};
  };
  CandidateMeasurement const run{
      .name = "another run",
      .cost = 1.0,
      .places = {at("upper_punch_force", "N", Phase::loading, 9e-3),
                 at("upper_punch_force", "N", Phase::loading, 8e-3),
                 at("wall_radial_pressure", "Pa", Phase::loading, 9e-3),
                 at("wall_radial_pressure", "Pa", Phase::loading, 8e-3),
                 at("upper_punch_force", "N", Phase::unloading, 8.2e-3)},
      .baseline = VectorXd{{100.0, 200.0, 1e6, 2e6, 50.0}},
      .calibrated = MatrixXd(5, 0),
      .effects = MatrixXd{{3.0, 0.0}, {0.0, 8.0}, {2e5, 0.0}, {0.0, 6e5}, {-5.0, 0.0}},
      .covariance = VectorXd{{1.0, 16.0, 1e10, 1e10, 1.0}}.asDiagonal()};
  auto const advice = next_measurements(plane.baseline, plane.library, possible, {run});
  ASSERT_EQ(advice[0].readings.size(), 2u);
  EXPECT_EQ(advice[0].readings[0].channel, "upper_punch_force");
  EXPECT_EQ(advice[0].readings[0].phase, Phase::unloading);
  EXPECT_EQ(advice[0].readings[0].gap, 8.2e-3);
  EXPECT_EQ(advice[0].readings[1].unit, "Pa");
  EXPECT_EQ(advice[0].readings[1].gap, 8e-3);
  ASSERT_EQ(advice[0].outcomes.size(), 2u);
  double const size = possible[0].fit.at.sizes[0];
  EXPECT_NEAR(size, 1.0, 1e-6);
  EXPECT_NEAR(advice[0].outcomes[0].value[0], 50.0 - 5.0 * size, 1e-9);
  EXPECT_NEAR(advice[0].outcomes[1].value[0], 50.0, 1e-9);
  EXPECT_NEAR(advice[0].outcomes[1].value[1], 2.6e6, 1.0);
  EXPECT_NEAR(advice[0].outcomes[1].sd[1], 1e5, 1e-6);
}

TEST(NextMeasurement, RefusesWhatDoesNotFit) {
  Plane const plane(MatrixXd{{10.0, 10.0}, {0.0, 0.0}, {0.0, 0.0}});
  std::vector<PossibleCause> possible;
  for (int const j : {0, 1})
    possible.push_back({j, fit_hypothesis(plane.comparison, {j}, VectorXd::Zero(1))});
  CandidateMeasurement good{.name = "gap gauge",
                            .cost = 1.0,
                            .places = {{.channel = "punch_gap", .unit = "m"}},
                            .baseline = VectorXd{{2.0}},
                            .calibrated = MatrixXd(1, 0),
                            .effects = MatrixXd{{1.0, 0.0}},
                            .covariance = MatrixXd{{0.04}}};
  auto const refused = [&](CandidateMeasurement const& one, std::size_t n) {
    return message_of([&] {
      (void)next_measurements(plane.baseline, plane.library,
                              {possible.begin(), possible.begin() + static_cast<Index>(n)}, {one});
    });
  };
  EXPECT_EQ(refused(good, 2), "no error");
  EXPECT_NE(refused(good, 1).find("1 causes are possible"), std::string::npos);
  auto bad = good;
  bad.cost = 0.0;
  EXPECT_NE(refused(bad, 2).find("gap gauge: costs 0"), std::string::npos);
  bad = good;
  bad.effects = MatrixXd{{1.0}};
  EXPECT_NE(refused(bad, 2).find("2 mechanisms"), std::string::npos);
  bad = good;
  bad.places.clear();
  EXPECT_NE(refused(bad, 2).find("has 1 rows, but places"), std::string::npos);
}
