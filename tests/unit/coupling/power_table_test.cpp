// Which instruments would show what: the five sets on a press whose law is known.
#include "coupling/finding/power_table.hpp"
#include "dem/expect.hpp"
#include "tests/support/near.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using namespace coupling;
using namespace coupling::finding;
using reduced::usual_instrument_sets;

namespace {

constexpr double mm_per_min = 1e-3 / 60.0;

reduced::Press press() {
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

/// A simulation of the bed, fitted as one of grains would be.
reduced::SimulatedPress simulated() {
  auto const course = reduced::press_course(20e-3, 7.5e-3, 0.2, 0.2);
  std::vector<double> samples;
  for (int k = 0; k <= 1000; ++k)
    samples.push_back(course.time.back() * k / 1000.0);
  reduced::SimulatedCycle cycle;
  for (auto const& at : press_cycle(press().pressed, {}, course, samples)) {
    cycle.height.push_back(at.height);
    cycle.upper.push_back(at.forces.upper);
    cycle.lower.push_back(at.forces.lower);
    cycle.radial_pressure.push_back(at.forces.radial_pressure);
  }
  auto fit = fit_bed_law(cycle, press().pressed.bed);
  auto nominal = press();
  nominal.pressed.law = fit.law;
  return {
      .nominal = nominal, .sheet = {.young_modulus = 2e9, .cohesion = 3e6}, .fit = std::move(fit)};
}

PowerTable made_table(reduced::Instruments const& with = {}, std::size_t n_grains = 0) {
  auto simulation = simulated();
  simulation.n_grains = n_grains;
  return power_table({.simulated = simulation,
                      .nominal = simulation.nominal,
                      .fill_height = 20e-3,
                      .instruments = with},
                     usual_instrument_sets(mm_per_min, 8e-3));
}

PowerTable const& usual_table() {
  static auto const table = made_table();
  return table;
}

reduced::PlannedRows rows_of(char const* set, reduced::Instruments const& with = {}) {
  auto const sets = usual_instrument_sets(mm_per_min, 8e-3);
  return planned_rows(press(), *std::ranges::find(sets, set, &reduced::InstrumentSet::name), with,
                      20e-3);
}

PowerColumn const& column(PowerTable const& table, char const* name) {
  return *std::ranges::find_if(table.columns,
                               [&](PowerColumn const& one) { return one.set.name == name; });
}

diagnosis::Power const& cause(PowerColumn const& of, char const* name) {
  return *std::ranges::find(of.causes, name, &diagnosis::Power::name);
}

} // namespace

TEST(InstrumentSets, AreThoseOfTheNote) {
  auto const sets = usual_instrument_sets(mm_per_min, 8e-3);
  ASSERT_EQ(sets.size(), 5u);
  std::vector<std::size_t> n_runs, n_gauges;
  for (auto const& one : sets) {
    n_runs.push_back(one.pressings.size());
    n_gauges.push_back(one.channels.size() + one.scalars.size());
  }
  EXPECT_EQ(n_runs, (std::vector<std::size_t>{1, 1, 2, 5, 5}));
  EXPECT_EQ(n_gauges, (std::vector<std::size_t>{1, 5, 5, 2, 5}));
  auto const& five = sets.back().pressings;
  EXPECT_DOUBLE_EQ(five[1].speed, 25.0 * mm_per_min);
  EXPECT_DOUBLE_EQ(five[2].gap, 8.4e-3);
  EXPECT_EQ(five[3].dwell, 60.0);
  EXPECT_DOUBLE_EQ(five[4].speed, 5.0 * mm_per_min);
  EXPECT_DOUBLE_EQ(five[4].gap, 8.2e-3);
}

TEST(InstrumentSets, HaveARowForEveryPartOfACycle) {
  // One before contact, 24, 16 and one after it.
  EXPECT_EQ(rows_of("A").plan.n_rows(), 42);
  // Lower force and radial pressure have none after it; two numbers of the compact.
  EXPECT_EQ(rows_of("D").plan.n_rows(), 42 + 2 * 41 + 2);
  auto const rows = rows_of("G");
  diagnosis::Observations const planned(rows.blocks); // coordinates and values hold
  EXPECT_EQ(planned.size(), rows.plan.n_rows());
  EXPECT_EQ(planned.values(), predict_plan(press(), rows.plan));
  auto const n_dwell =
      std::ranges::count(rows.blocks, diagnosis::Phase::dwell, &diagnosis::ChannelBlock::phase);
  EXPECT_EQ(n_dwell, 3); // of one run
  for (auto const& run : rows.plan.runs)
    EXPECT_TRUE(std::ranges::is_sorted(run.times));
  // The logger's readings of the upper force of run 1: 720 s down, 28.8 s up at 25 times the speed.
  double n_readings = 0.0;
  for (auto const& block : rows.blocks)
    if (block.run == "run1" && block.channel == "upper_punch_force")
      n_readings += block.n_readings.sum();
  EXPECT_NEAR(n_readings, 7488.0, 60.0); // whole readings in each row
}

TEST(InstrumentSets, KnowTheirInstruments) {
  auto const rows = rows_of("D", {.force_sd = 3.0, .height_sd = 1e-6, .n_repeats = 3});
  for (auto const& one : rows.channels) {
    if (one.channel == "lower_punch_force") {
      EXPECT_EQ(one.sd, 3.0);
    }
    if (one.channel == "compact_height") {
      EXPECT_EQ(one.sd, 1e-6);
    }
    EXPECT_EQ(one.has_kink,
              one.channel.ends_with("punch_force") || one.channel == "wall_radial_pressure");
  }
  for (auto const& block : rows.blocks)
    EXPECT_EQ(block.n_repeats, 3);
  // At 0.1 readings a second the opening of 28.8 s has two.
  auto const slow = rows_of("A", {.reading_rate = 0.1});
  EXPECT_LT(slow.blocks.back().values.size(), 3);
}

TEST(InstrumentSets, RefuseAGapAboveThePowder) {
  auto const sets = usual_instrument_sets(mm_per_min, 15e-3);
  try {
    (void)planned_rows(press(), sets[0], {}, 20e-3);
    FAIL() << "a bed that bears nothing was taken";
  } catch (dem::InvalidInput const& error) {
    EXPECT_NE(std::string(error.what()).find("set A: the bed does not bear at a gap of 0.015 m"),
              std::string::npos)
        << error.what();
  }
}

/// Further rows never hide anything: the same errors stand between the rows that two sets share.
TEST(PowerTable, GrowsWithInstrumentsAndRuns) {
  auto const& table = usual_table();
  constexpr double root_size = 3e-3;
  for (auto const& [less, more] :
       {std::pair{"A", "D"}, {"D", "E"}, {"E", "G"}, {"A", "F"}, {"F", "G"}})
    for (std::size_t j = 0; j < reduced::known_causes().size(); ++j) {
      auto const &a = column(table, less).causes[j], &b = column(table, more).causes[j];
      EXPECT_LE(b.detected, a.detected * (1.0 + root_size)) << a.name << ' ' << less << ' ' << more;
      EXPECT_LE(b.told, a.told * (1.0 + root_size)) << a.name << ' ' << less << ' ' << more;
      EXPECT_GE(b.told, b.detected) << b.name;
    }
}

/// What the note says of a single force curve: a gain error is a wrong modulus; the rate wants a
/// second speed.
TEST(PowerTable, KnowsWhatOneForceCurveCannotTell) {
  auto const& table = usual_table();
  auto const &A = column(table, "A"), &D = column(table, "D"), &E = column(table, "E");
  EXPECT_GT(cause(A, "force_gain").detected, 0.2); // five prior sizes
  EXPECT_LT(cause(D, "force_gain").detected, 0.04);
  EXPECT_GT(cause(A, "rate_dependence").told, 3.0 * cause(E, "rate_dependence").told);
  EXPECT_LT(cause(E, "rate_dependence").told, 0.02); // its prior size
}

TEST(PowerTable, GoesWithTheInstruments) {
  auto const& usual = usual_table();
  auto const fine = made_table({.height_sd = 1e-6, .n_repeats = 3});
  auto const detected = [](PowerTable const& of, char const* set, char const* name) {
    return cause(column(of, set), name).detected;
  };
  for (auto const* name : {"gap_offset", "mass_error", "frame_compliance"})
    EXPECT_LT(detected(fine, "D", name), 0.95 * detected(usual, "D", name)) << name;
}

/// Packings scatter less the more grains they have (packing_scatter), so smaller sizes show.
TEST(PowerTable, GoesWithTheNumberOfGrains) {
  auto const coarse = made_table({}, 2000), fine = made_table({}, 200000);
  for (std::size_t j = 0; j < reduced::known_causes().size(); ++j)
    for (auto const* set : {"A", "D"}) {
      auto const &few = column(coarse, set).causes[j], &many = column(fine, set).causes[j];
      EXPECT_LE(many.detected, few.detected * 1.003) << few.name;
    }
  EXPECT_LT(cause(column(fine, "D"), "frame_compliance").detected,
            0.5 * cause(column(coarse, "D"), "frame_compliance").detected);
}

TEST(PowerTable, IsWrittenForPeopleAndPrograms) {
  PowerTable table{.provenance = {.case_file = "case.prm",
                                  .data_folder = "",
                                  .version = "1",
                                  .simulation = "runs/a"},
                   .emulator = "the emulator",
                   .instruments = {},
                   .settings = {},
                   .calibrated = {},
                   .scatters = {{"mass", "1", 0.003}},
                   .tolerances = {},
                   .columns = {}};
  double const none = diagnosis::no_bound;
  diagnosis::Power const frame{"frame_compliance", "m/N",       2e-8, 3.6e-10,
                               5.84e-10,           "force_lag", 4.0};
  diagnosis::Power const lag{"force_lag", "s", 1.5, 0.0999, 0.1, "frame_compliance", 4.0};
  auto far = frame, unseen = lag;
  far.told = none, unseen.detected = unseen.told = none;
  auto const sets = usual_instrument_sets(mm_per_min, 8e-3);
  table.columns = {{sets[0], 42, {frame, lag}}, {sets[4], 650, {far, unseen}}};
  auto const page = power_markdown(table);
  for (auto const* line : {"| cause | prior size | A | G |", "|---|---|---|---|",
                           "| `frame_compliance` (µm/kN) | 20 | 0.36 / 0.58 (force_lag) | 0.36 / - "
                           "(force_lag) |",
                           "| `force_lag` (s) | 1.5 | 0.10 / 0.10 | - |",
                           "- A: upper force, one run; 42 rows; 1 mm/min to 8 mm.",
                           "25 mm/min to 8 mm, 1 mm/min to 8.4 mm, 1 mm/min to 8 mm and 60 s there",
                           "forces 12 N and 0.05 %", "Scatter from run to run: mass 0.003."})
    EXPECT_NE(page.find(line), std::string::npos) << line << '\n' << page;
  auto const text = power_text(table);
  EXPECT_NE(text.find("  1 frame_compliance [µm/kN]"), std::string::npos) << text;
  EXPECT_NE(text.find("0.36 / 0.58 (2)"), std::string::npos) << text;
  auto const json = nlohmann::json::parse(power_json(table));
  EXPECT_EQ(json["sets"][1]["rows"], 650);
  EXPECT_EQ(json["sets"][1]["runs"][3]["dwell"], 60.0);
  EXPECT_EQ(json["causes"][0]["sets"]["A"]["told"], 5.84e-10);
  EXPECT_EQ(json["causes"][0]["sets"]["A"]["rival"], "force_lag");
  EXPECT_TRUE(json["causes"][0]["sets"]["G"]["told"].is_null());
  EXPECT_TRUE(json["causes"][1]["sets"]["G"]["detected"].is_null());
  EXPECT_EQ(json["instruments"]["height_sd"], 15e-6);
  EXPECT_EQ(json["detected_at"], 5.0);
  EXPECT_EQ(json["told_at"], 4.0);
  EXPECT_EQ(json["provenance"]["simulation"], "runs/a");
}
