// Unknowns and their priors, the bounded fit, the projector.
#include "coupling/diagnosis/fit.hpp"
#include "coupling/diagnosis/tangent.hpp"
#include "tests/support/near.hpp"
#include "tests/unit/coupling/diagnosis_linear.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

namespace {

using namespace diagnosis_support;

Comparison compare(LinearModel const& model, std::uint64_t seed) {
  auto const n = model.offset.size();
  MatrixXd const S = random_covariance(1000 * seed, n);
  Whitener whitener(S, 1e-9);
  VectorXd const y = model.offset + 2.0 * whitener.unwhiten(normals(1000 * seed + 1, n, 1));
  return {&model, y, std::move(whitener)};
}

/// The same in units of the priors: columns of theta (sd 2), then of the active (scale 1.5).
MatrixXd design(LinearModel const& model, std::vector<int> const& active) {
  MatrixXd X(model.offset.size(), model.slopes.cols() + static_cast<Index>(active.size()));
  X.leftCols(model.slopes.cols()) = 2.0 * model.slopes;
  for (std::size_t k = 0; k < active.size(); ++k)
    X.col(model.slopes.cols() + static_cast<Index>(k)) = 1.5 * model.effects.col(active[k]);
  return X;
}

/// One row, exp(theta) with a wall: nothing but what a bound and a curve need.
struct Curve : Model {
  std::vector<CalibratedParameter> parameters;
  std::vector<Mechanism> causes;
  std::vector<Scatter> none;
  std::vector<CalibratedParameter> const& calibrated() const override { return parameters; }
  std::vector<Mechanism> const& mechanisms() const override { return causes; }
  std::vector<Scatter> const& scatters() const override { return none; }
  VectorXd predict(Parameters const& at) const override {
    VectorXd f(3);
    for (Index k = 0; k < 3; ++k)
      f[k] = at.calibrated[0] * std::pow(k + 1.0, causes.empty() ? 1.0 : at.shapes[0][0]) +
             (causes.empty() ? 0.0 : at.sizes[0]);
    return f;
  }
};

} // namespace

TEST(Fit, OfALinearModelIsGeneralisedLeastSquares) {
  auto const model = random_linear(21, 25, 2, 3);
  auto const data = compare(model, 22);
  auto const fit = fit_hypothesis(data, {2, 0}, VectorXd::Zero(4));
  MatrixXd const X = data.whitener.whiten(design(model, {2, 0}));
  VectorXd const r = data.whitener.whiten(data.target - model.offset);
  MatrixXd const H = X.transpose() * X + MatrixXd::Identity(4, 4);
  VectorXd const u = H.ldlt().solve(X.transpose() * r);
  EXPECT_TRUE(fit.has_come_to_rest);
  EXPECT_LT((fit.unknowns - u).norm(), 1e-3); // root of least_fall: no curvature is below 1
  EXPECT_NEAR(fit.objective(), r.squaredNorm() - r.dot(X * u), 1e-6);
  EXPECT_NEAR(fit.at.calibrated[1], 0.5 + 2.0 * fit.unknowns[1], 1e-14);
  EXPECT_NEAR(fit.at.sizes[0], 1.5 * fit.unknowns[3], 1e-14);
  EXPECT_EQ(fit.at.sizes[1], 0.0);
  EXPECT_LT((fit.slopes - X).norm(), 1e-8 * X.norm());
}

TEST(Fit, StaysInsideBoundsAndHoldsWhatIsHeld) {
  auto model = random_linear(31, 25, 1, 2);
  auto const data = compare(model, 32);
  auto const free = fit_hypothesis(data, {0}, VectorXd::Zero(2));
  LinearModel narrow = model;
  narrow.causes[0].low = -0.5 * std::abs(free.at.sizes[0]);
  narrow.causes[0].high = 0.5 * std::abs(free.at.sizes[0]);
  auto const held_back =
      fit_hypothesis({&narrow, data.target, data.whitener}, {0}, VectorXd::Zero(2));
  EXPECT_NEAR(held_back.at.sizes[0], 0.5 * free.at.sizes[0], 1e-12);
  auto const baseline = fit_baseline(data);
  LinearModel near = model; // the parameter may go half its way from 0.5
  double const half = 0.5 * (0.5 + baseline.at.calibrated[0]);
  (half > 0.5 ? near.parameters[0].high : near.parameters[0].low) = half;
  EXPECT_NEAR(fit_baseline({&near, data.target, data.whitener}).at.calibrated[0], half, 1e-12);
  auto const held = fit_hypothesis(data, {0}, VectorXd::Zero(2), {}, HeldUnknown{1, 0.7});
  EXPECT_NEAR(held.at.sizes[0], 0.7 * 1.5, 1e-14);
  EXPECT_GT(held.objective(), free.objective());
  LinearModel one_sided = model;
  one_sided.causes[0].is_one_sided = true;
  one_sided.effects.col(0) *= free.at.sizes[0] > 0.0 ? -1.0 : 1.0;
  EXPECT_EQ(
      fit_hypothesis({&one_sided, data.target, data.whitener}, {0}, VectorXd::Ones(2)).at.sizes[0],
      0.0);
}

TEST(Fit, FollowsACurveAndItsShape) {
  Curve model;
  model.parameters = {{.name = "E", .unit = "Pa", .mean = 2.0, .sd = 0.5, .is_logarithmic = true}};
  model.causes = {{.name = "c",
                   .unit = "N",
                   .scale = 100.0,
                   .shapes = {{.name = "power", .unit = "", .mean = 1.0, .sd = 0.5}}}};
  // f = 3 k^1.4 + 20 with sd 1e-4: the priors do not count, three rows fix three unknowns
  VectorXd const y{{23.0, 20.0 + 3.0 * std::pow(2.0, 1.4), 20.0 + 3.0 * std::pow(3.0, 1.4)}};
  Comparison const data{&model, y, Whitener(1e-8 * MatrixXd::Identity(3, 3), 1e-9)};
  auto const fit = fit_hypothesis(data, {0}, VectorXd::Zero(3));
  EXPECT_NEAR(fit.at.calibrated[0], 3.0, 1e-3);
  EXPECT_NEAR(fit.at.shapes[0][0], 1.4, 1e-3);
  EXPECT_NEAR(fit.at.sizes[0], 20.0, 1e-2);
  EXPECT_NEAR(fit.unknowns[0], std::log(1.5) / 0.5, 1e-3);
  EXPECT_TRUE(fit.has_come_to_rest);
  auto const cut_short = fit_hypothesis(data, {0}, VectorXd::Zero(3), {.most_steps = 1});
  EXPECT_FALSE(cut_short.has_come_to_rest);
  EXPECT_GT(cut_short.objective(), fit.objective());
  auto const content = fit_hypothesis(data, {0}, VectorXd::Zero(3), {.least_fall = 1e3});
  EXPECT_GT(content.objective(), fit.objective() + 1e-6);
  auto const coarse = fit_hypothesis(data, {0}, VectorXd::Zero(3), {.difference = 0.1});
  EXPECT_NE(coarse.slopes, fit.slopes);
}

TEST(Unknowns, PriorsAreTheNegativeLogarithmsOfTheirDensities) {
  LinearModel model = random_linear(1, 4, 1, 2);
  model.causes[1].tail = SizeTail::student;
  Unknowns const unknowns(model, {0, 1}, SizePriors::physical);
  for (double const x : {-3.0, -0.4, 0.0, 1e-7, 1.0, 2.5}) {
    VectorXd const u = VectorXd::Constant(3, x);
    VectorXd const rho = unknowns.prior_residual(u);
    EXPECT_EQ(rho[0], x);
    EXPECT_EQ(rho[1], x);
    // t with 4 degrees of freedom: density ~ (1 + x^2 / 4)^(-5/2)
    EXPECT_NEAR(0.5 * rho[2] * rho[2], 2.5 * std::log1p(x * x / 4.0), 1e-14);
    double const h = 1e-4;
    VectorXd const more = unknowns.prior_residual(u.array() + h);
    VectorXd const less = unknowns.prior_residual(u.array() - h);
    EXPECT_NEAR(unknowns.prior_slope(u)[2], (more[2] - less[2]) / (2.0 * h), 1e-7);
    auto const energy = [](double r) { return 0.5 * r * r; };
    EXPECT_NEAR(unknowns.prior_curvature(u)[2],
                (energy(more[2]) - 2.0 * energy(rho[2]) + energy(less[2])) / (h * h), 1e-6);
  }
  // densities at 0: 0.375 against 0.39894
  EXPECT_NEAR(unknowns.log_prior_height(), std::log(0.375 / 0.3989422804014327), 1e-12);
  Unknowns const flat(model, {1}, SizePriors::flat);
  EXPECT_EQ(flat.prior_residual(VectorXd::Ones(2))[1], 0.0);
  EXPECT_EQ(flat.prior_curvature(VectorXd::Ones(2))[1], 0.0);
}

TEST(Unknowns, AreTakenOutOfAWiderHypothesis) {
  Curve model;
  model.parameters = {{.name = "theta", .unit = "", .mean = 1.0, .sd = 1.0}};
  model.causes = {{.name = "a", .unit = "", .scale = 1.0},
                  {.name = "b",
                   .unit = "",
                   .scale = 1.0,
                   .shapes = {{.name = "s", .unit = "", .mean = 0.0, .sd = 1.0}}}};
  Unknowns const wider(model, {1, 0}, SizePriors::physical);
  VectorXd u = VectorXd::LinSpaced(wider.size(), 1.0, static_cast<double>(wider.size()));
  Unknowns const narrow(model, {1}, SizePriors::physical);
  EXPECT_EQ(narrow.out_of(wider, u), u.head(wider.size() - 1));
  VectorXd last(wider.n_calibrated() + 1);
  last << u.head(wider.n_calibrated()), u.tail(1);
  EXPECT_EQ(Unknowns(model, {0}, SizePriors::physical).out_of(wider, u), last);
}

TEST(Unknowns, RefusesMechanismsThatAreNotThere) {
  auto const model = random_linear(1, 4, 1, 2);
  for (std::vector<int> const& active : {std::vector{2}, std::vector{-1}, std::vector{1, 1}})
    EXPECT_NE(message_of([&] {
                Unknowns(model, active, SizePriors::physical);
              }).find("hypothesis: names mechanism"),
              std::string::npos);
}

TEST(Model, IsRefusedWithPriorsThatCannotBeUsed) {
  auto const refused = [](auto const& spoil) {
    LinearModel model = random_linear(1, 4, 1, 2);
    spoil(model);
    return message_of([&] { validate(model); });
  };
  EXPECT_EQ(refused([](LinearModel&) {}), "no error");
  EXPECT_NE(refused([](LinearModel& m) { m.causes[0].scale = 0.0; }).find("sd 0"),
            std::string::npos);
  EXPECT_NE(refused([](LinearModel& m) { m.parameters[0].sd = -1.0; }).find("sd -1"),
            std::string::npos);
  EXPECT_NE(refused([](LinearModel& m) { m.causes[0].low = 0.1; }).find("must lie between"),
            std::string::npos);
  EXPECT_NE(refused([](LinearModel& m) { m.causes[1].name = "cause0"; }).find("two unknowns"),
            std::string::npos);
  EXPECT_NE(refused([](LinearModel& m) {
              m.parameters[0].mean = -1.0;
              m.parameters[0].is_logarithmic = true;
            }).find("logarithmic"),
            std::string::npos);
  EXPECT_NE(refused([](LinearModel& m) {
              m.causes[0].shapes = {{.name = "s", .unit = "", .mean = 0.0, .sd = 0.0}};
            }).find("cause0/s"),
            std::string::npos);
  auto const model = random_linear(1, 4, 1, 2);
  EXPECT_NE(message_of([&] {
              (void)predict_rows(model, nominal_parameters(model), 5);
            }).find("predicts 4 rows where 5"),
            std::string::npos);
}

TEST(TangentSpace, RemovesWhatCalibrationAbsorbsAndNothingElse) {
  MatrixXd const J = normals(41, 30, 3);
  TangentSpace const tangent(J);
  MatrixXd basis(33, 3);
  basis << J, MatrixXd::Identity(3, 3);
  EXPECT_LT(tangent.project_extended(basis).norm(), 1e-13);
  MatrixXd const x = normals(42, 33, 2);
  MatrixXd const once = tangent.project_extended(x);
  EXPECT_LT((tangent.project_extended(once) - once).norm(), 1e-13);         // P P = P
  EXPECT_NEAR(x.col(0).dot(once.col(1)), once.col(0).dot(x.col(1)), 1e-12); // P' = P
  // |P [v ; 0]|^2 = v' (I + J J')^-1 v: what is left after calibration with its prior
  VectorXd const v = normals(43, 30, 1);
  MatrixXd const A = MatrixXd::Identity(30, 30) + J * J.transpose();
  EXPECT_NEAR(tangent.project(v).squaredNorm(), v.dot(A.ldlt().solve(v)), 1e-11);
  EXPECT_EQ(TangentSpace(MatrixXd(30, 0)).project(v), v);
}
