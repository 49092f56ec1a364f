#include "coupling/reduced/compact.hpp"
#include "coupling/reduced/error_sources.hpp"
#include "coupling/reduced/measured_course.hpp"
#include "coupling/reduced/measured_plan.hpp"
#include "coupling/reduced/press_model.hpp"
#include "dem/expect.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace coupling;
using namespace coupling::reduced;

namespace {

double const pi = std::acos(-1.0);

Press press() {
  return {.pressed = {.law = {.stiffness = 600e6,
                              .cohesion = 15e6,
                              .onset = 0.63,
                              .exponent = 1.6,
                              .recovery = 0.7,
                              .wall_friction = 0.2,
                              .radial_ratio = 0.5},
                      .bed = {.solid_area = 7.06e-3, .bore = 22.05e-3}},
          .machine = {},
          .solid_density = 3387.0};
}

/// What a laboratory would read of a press without any error but noise of the gap.
measured::MeasuredData laboratory(Press const& of, double dwell = 0.0, double gap_noise = 0.0) {
  measured::MeasuredData data{
      .sample = {.mass = {9.13e-3, 1e-5}, .die_diameter = {22.05e-3, 5e-6}},
      .channels = {{.name = "punch_gap", .unit = "m", .sd = 2e-6},
                   {.name = "upper_punch_force", .unit = "N", .sd = 12.0},
                   {.name = "lower_punch_force", .unit = "N", .sd = 12.0},
                   {.name = "wall_radial_pressure", .unit = "Pa", .sd = 8e4}},
      .gap_source = measured::GapSource::commanded,
      .runs = {}};
  measured::Run run{.file = "run1.csv",
                    .role = measured::Role::fit,
                    .press = {.speed_down = 1.6667e-5,
                              .speed_up = 4.1667e-4,
                              .end_gap = 8e-3,
                              .fill_height = 20e-3,
                              .dwell = dwell}};
  auto const course = press_course(20e-3, 8e-3, 1.6667e-5, 4.1667e-4, dwell);
  for (double t = 0.11; t < course.time.back(); t += t < 700.0 ? 0.37 : 0.031)
    run.time.push_back(t);
  std::mt19937 draw(1);
  std::normal_distribution<double> noise(0.0, 1.0);
  auto const cycle = press_cycle(of.pressed, of.machine, course, run.time);
  for (auto const& at : cycle) {
    run.series["punch_gap"].push_back(at.commanded_gap + gap_noise * noise(draw));
    run.series["upper_punch_force"].push_back(at.load_cell);
    run.series["lower_punch_force"].push_back(at.forces.lower);
    run.series["wall_radial_pressure"].push_back(at.forces.radial_pressure);
    run.rows.push_back(run.rows.size() + 2);
  }
  run.scalars["compact_height"] = {compact_number("compact_height", of, cycle), 2e-5};
  data.runs.push_back(std::move(run));
  return data;
}

Sheet const sheet{.young_modulus = 2e9, .cohesion = 3e6};

} // namespace

TEST(MeasuredCourse, FindsTheCornersOfANoisyGap) {
  for (double const dwell : {0.0, 60.0}) {
    auto const data = laboratory(press(), dwell, 2e-6);
    auto const course = measured_course(data, data.runs[0]);
    auto const turning = turning_of(course);
    double const closed = 12e-3 / 1.6667e-5;
    EXPECT_NEAR(turning.gap, 8e-3, 1.5e-6) << dwell;
    EXPECT_NEAR(turning.closed, closed, 0.1) << dwell; // 1.7 um of the way down
    EXPECT_NEAR(turning.opens, closed + dwell, 0.02) << dwell;
    EXPECT_NEAR(course.at(closed - 100.0), 8e-3 + 100.0 * 1.6667e-5, 1.5e-6);
  }
}

/// Rows are means of readings; the model foretells them by two nodes each.
TEST(MeasuredRows, AreForetoldByThePressThatMadeThem) {
  for (double const dwell : {0.0, 60.0}) {
    auto const data = laboratory(press(), dwell);
    auto const rows = measured_rows(data, measured::Role::fit);
    diagnosis::Observations const observations(rows.blocks);
    ASSERT_EQ(rows.plan.n_rows(), observations.size());
    auto const foretold = predict_plan(press(), rows.plan);
    for (std::size_t b = 0; b < rows.blocks.size(); ++b) {
      auto const [first, n] = observations.rows()[b];
      double const largest = rows.blocks[b].values.cwiseAbs().maxCoeff();
      double const off = (rows.blocks[b].values - foretold.segment(first, n)).cwiseAbs().maxCoeff();
      // The row in which the bed begins to bear, or the wall turns round, is no parabola.
      EXPECT_LT(off, 4e-3 * largest) << label_of(rows.blocks[b]);
    }
    bool const has_dwell = std::ranges::any_of(
        rows.blocks, [](auto const& block) { return block.phase == diagnosis::Phase::dwell; });
    EXPECT_EQ(has_dwell, dwell > 0.0);
  }
}

TEST(MeasuredRows, AreSurerThanTheirReadings) {
  auto const rows = measured_rows(laboratory(press()), measured::Role::fit);
  auto const n = laboratory(press()).runs[0].time.size();
  double sum = 0.0;
  for (auto const& block : rows.blocks)
    if (block.channel == "upper_punch_force")
      sum += block.n_readings.sum();
  EXPECT_EQ(sum, static_cast<double>(n)); // each reading is in one row
  EXPECT_THROW(measured_rows(laboratory(press()), measured::Role::held_out), dem::InvalidInput);
}

/// A load cell that is not zeroed bears nothing: the rows are of the same readings.
TEST(MeasuredRows, BeginWhereTheBedBearsWhateverTheZero) {
  Press const right = press();
  auto const rows = measured_rows(laboratory(right), measured::Role::fit);
  for (double const offset : {300.0, -300.0}) { // 1.2 % of the largest force
    Press wrong = right;
    wrong.machine.load_cell.offset = offset;
    auto const shifted = measured_rows(laboratory(wrong), measured::Role::fit);
    ASSERT_EQ(shifted.blocks.size(), rows.blocks.size());
    for (std::size_t b = 0; b < rows.blocks.size(); ++b)
      EXPECT_EQ(shifted.blocks[b].n_readings, rows.blocks[b].n_readings) << offset;
  }
}

/// An opening is over in a few readings: no row takes more than an eighth of the fall, so that two
/// of them lie at most a quarter apart.
TEST(MeasuredRows, FollowAForceThatFallsFast) {
  auto const rows = measured_rows(laboratory(press()), measured::Role::fit);
  auto const& opening = *std::ranges::find_if(rows.blocks, [](auto const& block) {
    return block.channel == "upper_punch_force" && block.phase == diagnosis::Phase::unloading;
  });
  auto const n = opening.values.size() - 1; // the last one is free of the compact
  ASSERT_GT(n, 10);
  double const fall = opening.values[0] - opening.values[n];
  EXPECT_LT((opening.values.head(n) - opening.values.tail(n)).maxCoeff(), 0.25 * fall);
}

TEST(PressModel, CalibratesStiffnessAndCohesion) {
  auto const rows = measured_rows(laboratory(press()), measured::Role::fit);
  PressModel const model(press(), sheet, {}, rows.plan);
  auto at = nominal_parameters(model);
  EXPECT_EQ(model.predict(at), predict_plan(press(), rows.plan));
  at.calibrated[0] = 2.2e9;
  at.calibrated[1] = 6e6;
  EXPECT_DOUBLE_EQ(model.press_at(at).pressed.law.stiffness, 1.1 * 600e6);
  EXPECT_DOUBLE_EQ(model.press_at(at).pressed.law.cohesion, 1.1 * 15e6 + 2.5 * 3e6);
  at.calibrated << 2e8, 1e5;
  EXPECT_EQ(model.press_at(at).pressed.law.cohesion, 0.0);
}

/// As causes both do what they do as calibrated parameters.
TEST(PressModel, ASheetThatIsWrongActsAsItsParameter) {
  auto const rows = measured_rows(laboratory(press()), measured::Role::fit);
  PressModel const model(press(), sheet, {}, rows.plan);
  auto const nominal = nominal_parameters(model);
  for (int p = 0; p < 2; ++p) {
    auto as_parameter = nominal, as_cause = nominal;
    as_parameter.calibrated[p] *= 1.4;
    for (std::size_t j = 0; j < known_causes().size(); ++j)
      if (known_causes()[j].mechanism.name == model.calibrated()[static_cast<std::size_t>(p)].name)
        as_cause.sizes[static_cast<Eigen::Index>(j)] = 0.4;
    auto const expected = model.predict(as_parameter);
    EXPECT_GT((expected - model.predict(nominal)).norm(), 1e-3 * expected.norm());
    EXPECT_NEAR((model.predict(as_cause) - expected).norm(), 0.0, 1e-12 * expected.norm());
  }
}

/// Every cause, at three prior sizes (a tilt shows by its square), moves some row by more than 5
/// standard uncertainties of its instrument; every shape parameter counts; at size 0 nothing is
/// there.
TEST(PressModel, EveryCauseIsLive) {
  auto data = laboratory(press(), 60.0);
  auto const rows = measured_rows(data, measured::Role::fit);
  PressModel const model(press(), sheet, {}, rows.plan);
  auto const base = model.predict(nominal_parameters(model));
  double const instrument = 12.0;
  for (std::size_t j = 0; j < model.mechanisms().size(); ++j) {
    auto const& mechanism = model.mechanisms()[j];
    auto at = nominal_parameters(model);
    auto const place = static_cast<Eigen::Index>(j);
    at.sizes[place] = 3.0 * mechanism.scale;
    auto const moved = model.predict(at);
    // Upper and lower forces come first; radial pressure in Pa would say nothing here.
    auto const n_upper = static_cast<Eigen::Index>(
        rows.blocks[0].values.size() + rows.blocks[1].values.size() + rows.blocks[2].values.size());
    EXPECT_GT((moved - base).head(n_upper).cwiseAbs().maxCoeff(), 5.0 * instrument)
        << mechanism.name;
    for (std::size_t s = 0; s < mechanism.shapes.size(); ++s) {
      auto shaped = at;
      shaped.shapes[j][static_cast<Eigen::Index>(s)] += mechanism.shapes[s].sd;
      EXPECT_GT((model.predict(shaped) - moved).cwiseAbs().maxCoeff(), 1e-3 * instrument)
          << mechanism.name << ", " << mechanism.shapes[s].name;
    }
  }
}

/// Student's t lets a search go far: nowhere inside the bounds does it leave the laws.
TEST(PressModel, StaysALawWhereverASearchAsks) {
  auto const rows = measured_rows(laboratory(press()), measured::Role::fit);
  PressModel const model(press(), sheet, {}, rows.plan);
  for (double const scales : {-30.0, -3.0, 3.0, 30.0})
    for (std::size_t j = 0; j < model.mechanisms().size(); ++j)
      for (double const shape_sds : {-5.0, 0.0, 5.0}) {
        auto const& one = model.mechanisms()[j];
        auto at = nominal_parameters(model);
        at.sizes[static_cast<Eigen::Index>(j)] =
            std::clamp(scales * one.scale, one.is_one_sided ? 0.0 : one.low, one.high);
        for (std::size_t s = 0; s < one.shapes.size(); ++s)
          at.shapes[j][static_cast<Eigen::Index>(s)] =
              std::clamp(one.shapes[s].mean + shape_sds * one.shapes[s].sd, one.shapes[s].low,
                         one.shapes[s].high);
        EXPECT_NO_THROW(predict_rows(model, at, rows.plan.n_rows())) << one.name << ' ' << scales;
      }
}

TEST(PressModel, CausesDoWhatTheyAreCalled) {
  auto const after = [](char const* name, double size) {
    Press changed = press();
    for (auto const& cause : known_causes())
      if (cause.mechanism.name == name) {
        Eigen::VectorXd shapes(static_cast<Eigen::Index>(cause.mechanism.shapes.size()));
        for (Eigen::Index s = 0; s < shapes.size(); ++s)
          shapes[s] = cause.mechanism.shapes[static_cast<std::size_t>(s)].mean;
        cause.apply(changed, size, shapes);
      }
    return changed;
  };
  auto const& plain = press().pressed;
  EXPECT_DOUBLE_EQ(after("frame_compliance", 20e-9).machine.frame.stiffness, 1.0 / 20e-9);
  EXPECT_DOUBLE_EQ(after("frame_compliance", 20e-9).machine.frame.seating, 0.15 * 20e-9 * 3e3);
  EXPECT_EQ(after("gap_offset", 1e-4).machine.frame.gap_offset, 1e-4);
  EXPECT_EQ(after("thermal_drift", 1e-7).machine.frame.thermal_drift, 1e-7);
  EXPECT_DOUBLE_EQ(after("force_gain", 0.04).machine.load_cell.gain, 1.04);
  EXPECT_EQ(after("force_offset", 50.0).machine.load_cell.offset, 50.0);
  EXPECT_EQ(after("force_lag", 1.5).machine.load_cell.lag, 1.5);
  EXPECT_DOUBLE_EQ(after("mass_error", 0.01).pressed.bed.solid_area, 1.01 * plain.bed.solid_area);
  auto const wide = after("die_size", 1e-4).pressed.bed;
  EXPECT_DOUBLE_EQ(wide.bore, 22.15e-3);
  EXPECT_NEAR(wide.solid_area * wide.bore * wide.bore,
              plain.bed.solid_area * plain.bed.bore * plain.bed.bore, 1e-18);
  EXPECT_EQ(after("punch_tilt", 2e-4).pressed.tilt, 2e-4);
  EXPECT_DOUBLE_EQ(after("wall_friction", 0.05).pressed.law.wall_friction, 0.235);
  EXPECT_DOUBLE_EQ(after("wall_friction", 0.05).pressed.law.recovery, 0.73);
  EXPECT_EQ(after("wall_friction", -0.5).pressed.law.wall_friction, 0.0);
  EXPECT_EQ(after("missing_fines", 0.01).pressed.law.onset_fines.size, 0.01);
  EXPECT_EQ(after("missing_fines", 0.01).pressed.law.onset_fines.fade, 0.3);
  EXPECT_EQ(after("fill_state", 0.01).pressed.law.onset_fill.size, 0.01);
  EXPECT_EQ(after("fill_state", 0.01).pressed.law.onset_fill.tail, 0.5);
  EXPECT_EQ(after("breakage", 0.01).pressed.law.onset_crush.size, 0.01);
  EXPECT_DOUBLE_EQ(after("young_modulus", 0.5).pressed.law.stiffness, 900e6);
  EXPECT_DOUBLE_EQ(after("young_modulus", 0.5).pressed.law.cohesion, 1.5 * plain.law.cohesion);
  EXPECT_EQ(after("die_compliance", 1e-13).pressed.die_yield, 1e-13);
  EXPECT_EQ(after("rate_dependence", 0.02).pressed.rate.gain, 0.02);
  EXPECT_DOUBLE_EQ(after("multi_contact", 0.3).pressed.law.stiffening.size,
                   0.3 * 0.3 / std::pow(0.25, 3.0));
  EXPECT_DOUBLE_EQ(after("plastic_contacts", 0.2).pressed.law.yielding.size, 0.06);
  EXPECT_DOUBLE_EQ(after("plastic_contacts", 0.2).pressed.law.recovery, 0.7 * (1.0 - 0.7 * 0.2));
  auto const rough = after("particle_friction", 0.1).pressed.law;
  EXPECT_DOUBLE_EQ(rough.onset, 0.63 - 0.0055);
  EXPECT_DOUBLE_EQ(rough.radial_ratio, 0.5 - 0.074);
  EXPECT_DOUBLE_EQ(rough.recovery, 0.7 - 0.016);
  EXPECT_DOUBLE_EQ(rough.stiffness, 600e6);
}

TEST(CompactNumbers, AreThoseOfTheCompact) {
  auto const of = press();
  auto const course = press_course(20e-3, 8e-3, 1e-3, 1e-3);
  auto const cycle = press_cycle(of.pressed, of.machine, course, {11.0, 12.0, 13.0});
  auto const compact = free_compact(of.pressed.law, of.pressed.bed, 8e-3);
  EXPECT_EQ(compact_number("compact_height", of, cycle), compact.height);
  EXPECT_EQ(compact_number("compact_diameter", of, cycle), 22.05e-3);
  double const area = 0.25 * pi * 22.05e-3 * 22.05e-3;
  EXPECT_NEAR(compact_number("compact_mass", of, cycle), 3387.0 * 7.06e-3 * area, 1e-12);
  EXPECT_NEAR(compact_number("porosity", of, cycle), 1.0 - 7.06e-3 / compact.height, 1e-12);
  EXPECT_EQ(compact_number("gap_at_peak", of, cycle), 8e-3);
  EXPECT_EQ(compact_number("max_force", of, cycle), cycle[1].load_cell);
  EXPECT_NEAR(compact_number("ejection_force", of, cycle),
              0.2 * compact.radial_pressure * pi * 22.05e-3 * compact.height, 1e-6);
  Press wrong = of;
  wrong.machine.load_cell = {.gain = 1.02, .offset = 30.0};
  EXPECT_NEAR(compact_number("dead_weight", wrong, cycle), 1.02 * 10e3 + 30.0, 1e-9);
  EXPECT_FALSE(is_foretold("colour"));
}

TEST(RepeatScatter, IsThatOfTheCellAndTheGrains) {
  SimulatedPress simulated{};
  auto const scatter = repeat_scatter(simulated, {{.channel = "upper_punch_force", .sd = 1.5}});
  EXPECT_EQ(scatter.force_zero, 0.5);
  EXPECT_EQ(scatter.onset, RepeatScatter{}.onset);
  simulated.n_grains = 2204;
  auto const of_grains = repeat_scatter(simulated, {});
  EXPECT_EQ(of_grains.force_zero, RepeatScatter{}.force_zero);
  EXPECT_EQ(of_grains.onset, 0.0);
}

TEST(RepeatScatter, MovesWhatItIsCalled) {
  Press changed = press();
  Eigen::VectorXd departure(5);
  departure << 0.01, 0.002, 0.1, 1e-5, 3.0;
  apply_scatter(changed, departure);
  EXPECT_DOUBLE_EQ(changed.pressed.bed.solid_area, 1.01 * 7.06e-3);
  EXPECT_DOUBLE_EQ(changed.pressed.law.onset, 0.632);
  EXPECT_DOUBLE_EQ(changed.pressed.law.wall_friction, 0.22);
  EXPECT_EQ(changed.machine.frame.gap_offset, 1e-5);
  EXPECT_EQ(changed.machine.load_cell.offset, 3.0);
  EXPECT_EQ(scatters_of({}).size(), 5u);
}
