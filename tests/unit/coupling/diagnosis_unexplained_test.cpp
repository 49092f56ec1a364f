// The description of a misfit without a known cause.
#include "coupling/diagnosis/residual_forms.hpp"
#include "coupling/diagnosis/unexplained.hpp"
#include "tests/unit/coupling/diagnosis_linear.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

namespace {

using namespace diagnosis_support;

constexpr Index n_phase = 30;

/// Three runs of force in loading and one of height, errors of 1 and a linear calibration.
struct Bench {
  LinearModel model;
  VectorXd s = VectorXd::LinSpaced(n_phase, 0.0, 1.0), force, speed, zigzag;

  Bench() {
    auto const n = 3 * n_phase + 1;
    force.resize(n);
    speed.resize(n);
    for (Index run = 0; run < 3; ++run) {
      force.segment(run * n_phase, n_phase) = 1000.0 * s.array().square();
      speed.segment(run * n_phase, n_phase).setConstant(static_cast<double>(run));
    }
    force[n - 1] = 9.0;
    speed[n - 1] = 2.0;
    zigzag = normals(8, n, 1);
    model.offset = force;
    model.slopes = 0.1 * force;
    model.parameters = {{.name = "E", .unit = "Pa", .mean = 1.0, .sd = 0.5}};
    model.effects = MatrixXd::Zero(n, 1);
    model.effects.block(0, 0, 3 * n_phase, 1) = (0.01 * force.head(3 * n_phase).array()).square();
    model.causes = {{.name = "hardening", .unit = "", .scale = 1.0}};
  }

  Unexplained describe(VectorXd const& extra, std::uint64_t seed) const {
    VectorXd const y = model.offset + normals(seed, force.size(), 1) + extra;
    std::vector<ChannelBlock> blocks;
    for (Index run = 0; run < 3; ++run)
      blocks.push_back(block("run" + std::to_string(run), "force", Phase::loading,
                             y.segment(run * n_phase, n_phase)));
    blocks.push_back(block("run2", "height", Phase::after, y.tail(1)));
    Observations const data(blocks);
    MatrixXd const one = MatrixXd::Identity(y.size(), y.size());
    Comparison const comparison{&model, y, Whitener(one, 1e-9)};
    auto const baseline = fit_baseline(comparison);
    auto const library = signature_library(comparison, baseline);
    MisfitSettings const settings{.n_draws = 400};
    return describe_unexplained(data, comparison, library,
                                test_misfit(data, comparison, one, library, settings),
                                baseline.predicted, inputs(), settings);
  }
  std::vector<RowInput> inputs() const {
    VectorXd coordinate(force.size());
    for (Index run = 0; run < 3; ++run)
      coordinate.segment(run * n_phase, n_phase) = s;
    coordinate[force.size() - 1] = 0.0;
    return {{"phase coordinate", "1", coordinate},
            {"ln speed", "1", speed},
            {"room humidity", "1", zigzag}};
  }
  /// `height` times a function of the coordinate in the runs from `first` on.
  VectorXd extra(double height, Index first, auto const& function) const {
    VectorXd added = VectorXd::Zero(force.size());
    for (Index run = first; run < 3; ++run)
      for (Index k = 0; k < n_phase; ++k)
        added[run * n_phase + k] = height * function(s[k]);
    return added;
  }
};

FormCandidate const& best_in(Unexplained const& found, std::string const& form) {
  return *std::ranges::find(found.forms, form, &FormCandidate::form);
}

} // namespace

TEST(Unexplained, FindsABumpWhereItIs) {
  Bench const bench;
  auto const found = bench.describe(
      bench.extra(12.0, 0, [](double s) { return std::exp(-0.5 * std::pow((s - 0.6) / 0.1, 2)); }),
      11);
  EXPECT_EQ(found.channel, "force");
  EXPECT_EQ(found.phase, Phase::loading);
  EXPECT_EQ(found.forms.front().form, "bump");
  EXPECT_EQ(found.forms.front().input, "phase coordinate");
  EXPECT_NEAR(found.forms.front().place, 0.6, 0.051); // places are 0.05 apart
  EXPECT_NEAR(found.forms.front().width, 0.1, 1e-12);
  EXPECT_NEAR(found.forms.front().amplitude, 12.0, 2.0);
  EXPECT_GT(found.forms.front().share, 0.9);
  // 80 % lies where |s - 0.6| < 0.1: forces from 250 to 490
  EXPECT_GT(found.value_low, 150.0);
  EXPECT_LT(found.value_high, 700.0);
  EXPECT_NEAR(found.size, 12.0, 4.0);
  EXPECT_NEAR(found.run_share, 1.0 / 3.0, 0.1);
  EXPECT_EQ(found.inputs.front().input, "phase coordinate");
  EXPECT_LT(found.inputs.front().p, 1e-6);
  EXPECT_GT(found.inputs.back().p, 1e-4); // humidity has nothing to do with it
}

TEST(Unexplained, FindsStickSlipAStepAndThePower) {
  Bench const bench;
  auto const periodic = bench.describe(
      bench.extra(5.0, 0, [](double s) { return std::sin(2.0 * std::numbers::pi * s * 5.0); }), 12);
  EXPECT_EQ(periodic.forms.front().form, "periodic");
  EXPECT_NEAR(periodic.forms.front().width, 0.2, 1e-12);
  EXPECT_NEAR(periodic.forms.front().amplitude, 5.0, 1.0);
  auto const step =
      bench.describe(bench.extra(8.0, 0, [](double s) { return s >= 0.31 ? 1.0 : 0.0; }), 13);
  EXPECT_EQ(step.forms.front().form, "step");
  EXPECT_NEAR(step.forms.front().place, 0.3, 0.051);
  auto const power =
      bench.describe(bench.extra(40.0, 0, [](double s) { return std::pow(s, 6); }), 14);
  EXPECT_EQ(best_in(power, "power").place, 3.0); // F ~ s^2
  EXPECT_GT(best_in(power, "power").share, 0.9);
}

TEST(Unexplained, FindsTheInputAndTheRun) {
  Bench const bench;
  VectorXd offset = VectorXd::Zero(bench.force.size());
  offset.head(3 * n_phase) = 3.0 * bench.speed.head(3 * n_phase);
  auto const found = bench.describe(offset, 15);
  EXPECT_EQ(found.inputs.front().input, "ln speed");
  EXPECT_EQ(found.forms.front().input, "ln speed");
  EXPECT_EQ(found.run, "run2");
  EXPECT_GT(found.run_share, 0.6); // 4 of 0 + 1 + 4, less noise
}

TEST(Unexplained, NamesTheNearestSignatureWithItsSign) {
  Bench const bench;
  auto const found = bench.describe(-0.3 * bench.model.effects, 16);
  EXPECT_EQ(found.nearest, "hardening");
  EXPECT_LT(found.nearest_cosine, -0.8);
}

TEST(Unexplained, RefusesInputsThatDoNotFit) {
  Bench const bench;
  auto inputs = bench.inputs();
  LinearModel const& model = bench.model;
  VectorXd const y = model.offset;
  Observations const data({block("a", "force", Phase::loading, y)});
  Comparison const comparison{&model, y, Whitener(MatrixXd::Identity(y.size(), y.size()), 1e-9)};
  auto const baseline = fit_baseline(comparison);
  auto const library = signature_library(comparison, baseline);
  auto const refused = [&](std::vector<RowInput> const& given) {
    return message_of([&] {
      (void)describe_unexplained(data, comparison, library, {}, baseline.predicted, given);
    });
  };
  EXPECT_NE(refused({}).find("no inputs"), std::string::npos);
  inputs[1].values.conservativeResize(3);
  EXPECT_NE(refused(inputs).find("ln speed: has 3 values for 91 rows"), std::string::npos);
  inputs = bench.inputs();
  inputs[0].values[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refused(inputs).find("phase coordinate"), std::string::npos);
  // An input that is the same in all rows has no forms.
  EXPECT_TRUE(forms_in({"mass", "kg", VectorXd::Ones(5)}, {0, 1, 2}).empty());
  EXPECT_EQ(polynomial_columns({"mass", "kg", VectorXd::Ones(5)}, {0, 1, 2}).cols(), 1);
}
