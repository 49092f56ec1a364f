#include "coupling/case_file.hpp"
#include "coupling/finding/case_diagnosis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace coupling;
using namespace coupling::finding;

namespace {

reduced::BedLaw const law{.stiffness = 600e6,
                          .cohesion = 15e6,
                          .onset = 0.63,
                          .exponent = 1.6,
                          .recovery = 0.8,
                          .wall_friction = 0.2,
                          .radial_ratio = 0.5};
reduced::Bed const bed{.solid_area = 7.06e-3, .bore = 22.05e-3};

/// A simulation of the bed, fitted as one of grains would be.
reduced::SimulatedPress simulated(reduced::BedLaw const& of = law) {
  auto const course = reduced::press_course(20e-3, 7.5e-3, 0.2, 0.2);
  std::vector<double> samples;
  for (int k = 0; k <= 1000; ++k)
    samples.push_back(course.time.back() * k / 1000.0);
  reduced::SimulatedCycle cycle;
  for (auto const& at : press_cycle({.law = of, .bed = bed}, {}, course, samples)) {
    cycle.height.push_back(at.height);
    cycle.upper.push_back(at.forces.upper);
    cycle.lower.push_back(at.forces.lower);
    cycle.radial_pressure.push_back(at.forces.radial_pressure);
  }
  auto fit = fit_bed_law(cycle, bed);
  reduced::Press nominal{
      .pressed = {.law = fit.law, .bed = bed}, .machine = {}, .solid_density = 3386.0};
  return {
      .nominal = nominal, .sheet = {.young_modulus = 2e9, .cohesion = 3e6}, .fit = std::move(fit)};
}

/// A pressing in a machine with its errors, read with noise.
measured::Run pressing(std::string const& file, measured::Role role, double end_gap, double speed,
                       reduced::Machine const& machine, reduced::BedLaw const& of,
                       std::mt19937& draw) {
  std::normal_distribution<double> noise(0.0, 1.0);
  measured::Run run{.file = file,
                    .role = role,
                    .press = {.speed_down = speed,
                              .speed_up = 4e-4,
                              .end_gap = end_gap,
                              .fill_height = 20e-3,
                              .dwell = {}}};
  auto const course = reduced::press_course(20e-3, end_gap, speed, 4e-4);
  for (double t = 0.05; t < course.time.back();
       t += t < (20e-3 - end_gap) / speed ? 1e-5 / speed : 0.03)
    run.time.push_back(t);
  for (auto const& at : press_cycle({.law = of, .bed = bed}, machine, course, run.time)) {
    run.series["punch_gap"].push_back(at.commanded_gap + 2e-6 * noise(draw));
    run.series["upper_punch_force"].push_back(at.load_cell + 12.0 * noise(draw));
    run.series["lower_punch_force"].push_back(at.forces.lower + 12.0 * noise(draw));
    run.rows.push_back(run.rows.size() + 2);
  }
  return run;
}

measured::MeasuredData laboratory(reduced::Machine const& machine,
                                  reduced::BedLaw const& of = law) {
  std::mt19937 draw(7);
  return {
      .sample = {.mass = {bed.solid_area * 3386.0 * 0.25 * std::acos(-1.0) * bed.bore * bed.bore,
                          1e-5},
                 .die_diameter = {bed.bore, 5e-6}},
      .channels = {{.name = "punch_gap", .unit = "m", .sd = 2e-6},
                   {.name = "upper_punch_force", .unit = "N", .sd = 12.0},
                   {.name = "lower_punch_force", .unit = "N", .sd = 12.0}},
      .gap_source = measured::GapSource::commanded,
      .runs = {pressing("run1.csv", measured::Role::fit, 8e-3, 1.7e-5, machine, of, draw),
               pressing("run2.csv", measured::Role::held_out, 7.7e-3, 1.7e-5, machine, of, draw),
               pressing("run3.csv", measured::Role::held_out, 8.2e-3, 8e-5, machine, of, draw)}};
}

Finding diagnosed(reduced::Machine const& machine) {
  Case const setup = parse_case("set Title = Test\n", "case.prm");
  auto const data = laboratory(machine);
  auto const simulation = simulated();
  return CaseDiagnosis({.setup = setup, .data = data, .simulated = simulation, .provenance = {}})
      .finding();
}

} // namespace

TEST(CaseDiagnosis, IsSilentWhereNothingIsWrong) {
  auto const found = diagnosed({});
  EXPECT_EQ(found.verdict, "consistent");
  EXPECT_FALSE(found.gain.has_value());
  EXPECT_EQ(found.detectable.size(), reduced::known_causes().size());
}

TEST(CaseDiagnosis, SaysWhatIsAssumedOfPackings) {
  auto simulation = simulated();
  EXPECT_EQ(uncertainty_of(simulation).onset, 0.0012);
  EXPECT_NE(packings_in_words(simulation).find("onset is taken to be unsure by 0.0012"),
            std::string::npos);
  simulation.n_grains = 2204, simulation.n_packings = 3;
  EXPECT_EQ(uncertainty_of(simulation).onset, 0.0);
  EXPECT_EQ(uncertainty_of(simulation).packing.stress, 0.011);
  EXPECT_EQ(packings_in_words(simulation).substr(0, 57),
            "3 packings of 2204 grains stand for the simulation; a pac");
}

TEST(CaseDiagnosis, MorePackingsAreLessUnsure) {
  auto const data = laboratory({});
  auto const rows = reduced::measured_rows(data, measured::Role::fit);
  auto simulation = simulated();
  simulation.n_grains = 2204;
  reduced::PressModel const model(simulation.nominal, simulation.sheet, {}, rows.plan);
  auto const variance = [&](std::size_t n_packings) {
    simulation.n_packings = n_packings;
    return numerical_covariance(model, simulation.fit, uncertainty_of(simulation))
        .diagonal()
        .eval();
  };
  // One share for the simulation, one for the pressing itself: 2, 5/4 and 1 of the same.
  Eigen::VectorXd const one = variance(1), four = variance(4), many = variance(1'000'000'000);
  EXPECT_NEAR((one - four).norm(), 3.0 * (four - many).norm(), 1e-6 * one.norm());
  EXPECT_GT(one.sum(), 1.5 * many.sum());
}

TEST(CaseDiagnosis, NamesASoftFrameAndMeasuresTheGain) {
  auto const found = diagnosed({.frame = {.stiffness = 50e6}});
  ASSERT_EQ(found.verdict, "named");
  ASSERT_FALSE(found.causes.empty());
  EXPECT_EQ(found.causes.front().name, "frame_compliance");
  EXPECT_NEAR(found.causes.front().size(), 20e-9, 4e-9);
  ASSERT_TRUE(found.gain.has_value());
  auto const all = std::ranges::find(found.gain->channels, "all", &ChannelGained::channel);
  ASSERT_NE(all, found.gain->channels.end());
  EXPECT_LT(all->ratio, 0.5);
  EXPECT_EQ(found.gain->n_runs, 2);
  ASSERT_TRUE(found.placebo.has_value());
  auto const placebo = std::ranges::find(found.placebo->channels, "all", &ChannelGained::channel);
  EXPECT_GT(placebo->after, all->after);
}

/// The upper force alone cannot tell a wrong zero of the gap from what does the same to the bed.
TEST(CaseDiagnosis, ForetellsTheNextMeasurementInTheUnitsOfItsReadings) {
  Case const setup = parse_case("set Title = Test\n", "case.prm");
  auto data = laboratory({.frame = {.gap_offset = 2.5e-4}});
  data.channels.pop_back();
  for (auto& run : data.runs)
    run.series.erase("lower_punch_force");
  auto const simulation = simulated();
  auto const found =
      CaseDiagnosis({.setup = setup, .data = data, .simulated = simulation, .provenance = {}})
          .finding();
  ASSERT_EQ(found.verdict, "undecided");
  ASSERT_GE(found.measurements.size(), 10u);
  for (auto const& one : found.measurements) {
    ASSERT_EQ(one.readings.size(), 1u) << one.name; // a channel or a number each
    auto const& reading = one.readings.front();
    EXPECT_EQ(reading.unit,
              reading.channel == "wall_radial_pressure"                                 ? "Pa"
              : reading.channel == "compact_mass"                                       ? "kg"
              : reading.channel.ends_with("_force") || reading.channel == "dead_weight" ? "N"
                                                                                        : "m")
        << reading.channel;
    double const least = one.name == "a run to an end gap 5 % larger" ? 8.4e-3 : 8e-3;
    EXPECT_GE(reading.gap, least * (1.0 - 1e-6)) << one.name;
    EXPECT_LE(reading.gap, reading.phase == "after" ? least * (1.0 + 1e-6) : 11e-3) << one.name;
    for (auto const& outcome : one.outcomes) {
      ASSERT_EQ(outcome.value.size(), 1u);
      EXPECT_GT(outcome.sd.front(), 0.0);
    }
  }
}

TEST(CaseDiagnosis, SimulationsShowHowMuchOfAnEffectTheyHave) {
  Case const setup = parse_case("set Title = Test\n", "case.prm");
  auto yielding = law;
  yielding.yielding = {.size = 0.15, .stress = 20e6};
  yielding.recovery *= 0.65;
  auto const data = laboratory({}, yielding);
  auto const simulation = simulated();
  CaseDiagnosis const diagnosis(
      {.setup = setup, .data = data, .simulated = simulation, .provenance = {}});
  auto const found = diagnosis.finding();
  ASSERT_EQ(found.verdict, "named");
  ASSERT_EQ(found.causes.front().name, "plastic_contacts");
  auto const shown = [&](double share) {
    auto part = law;
    part.yielding = {.size = 0.15 * share, .stress = 20e6};
    part.recovery *= 1.0 - 0.35 * share;
    return diagnosis.effect_shown("plastic_contacts", simulation, simulated(part));
  };
  EXPECT_NEAR(shown(1.0), 1.0, 0.05);
  EXPECT_NEAR(shown(0.5), 0.5, 0.1);
  EXPECT_NEAR(shown(0.0), 0.0, 1e-12);
  EXPECT_THROW(diagnosis.effect_shown("force_gain", simulation, simulation), std::out_of_range);
}
