#include "coupling/case_file.hpp"
#include "coupling/finding/height_diagnosis.hpp"
#include "coupling/finding/height_words.hpp"
#include "coupling/reduced/measured_plan.hpp"
#include "coupling/reduced/pressed_height.hpp"
#include "dem/expect.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace coupling;
using namespace coupling::finding;
using reduced::Asked;

namespace {

constexpr double bore = 22.05e-3, mass = 9.13e-3, density = 3500.0;
double const area = std::numbers::pi / 4.0 * bore * bore;

reduced::PressedHeight::Known known() {
  reduced::Press nominal;
  nominal.solid_density = density;
  nominal.pressed.bed = {.solid_area = mass / density / area, .bore = bore};
  return {.nominal = nominal,
          .solid_density = {density, 70.0},
          .gap_sd = 0.05e-3,
          .mass_sd = 1e-3,
          .stroke = 12e-3};
}

/// 25 kN at 8 mm, 600 s after the start.
reduced::HeightRow row(Asked asked) {
  return {.asked = asked, .gap = 8e-3, .force = 25e3, .time = 600.0};
}

double value_at(Asked asked, std::string const& cause, double size) {
  reduced::PressedHeight const model(known(), {row(Asked::porosity)});
  auto at = nominal_parameters(model);
  at.calibrated[0] = 0.03;
  at.calibrated[1] = 3600.0;
  for (std::size_t j = 0; j < model.mechanisms().size(); ++j)
    if (model.mechanisms()[j].name == cause)
      at.sizes[static_cast<Eigen::Index>(j)] = size;
  return model.with_rows({row(asked)}).predict(at)[0];
}

/// Pressings to 8 mm with these forces and compact heights, everything else exact.
measured::MeasuredData pressings(std::vector<std::array<double, 2>> const& force_and_height) {
  measured::MeasuredData data{.sample = {.mass = {mass, 1e-5}, .die_diameter = {bore, 1e-5}},
                              .channels = {{"punch_gap", "m", 20e-6}},
                              .gap_source = measured::GapSource::commanded,
                              .runs = {}};
  for (auto const& [force, height] : force_and_height)
    data.runs.push_back(
        {.file = "press " + std::to_string(data.runs.size() + 1),
         .role = measured::Role::fit,
         .press = {.speed_down = 2e-5,
                   .speed_up = 4e-4,
                   .end_gap = 8e-3,
                   .fill_height = 20e-3,
                   .dwell = {}},
         .scalars = {{"max_force", {force, 20.0}}, {"compact_height", {height, 20e-6}}}});
  return data;
}

Finding found(std::vector<std::array<double, 2>> const& force_and_height) {
  Case const setup = read_case(PRESSCHECK_SOURCE_DIR "/cases/quick/case.prm");
  return diagnose_heights(setup, pressings(force_and_height), {});
}

bool has(std::vector<std::string> const& names, std::string const& name) {
  return std::ranges::count(names, name) > 0;
}

} // namespace

TEST(PressedHeight, IsTheFacesGapWithSpringback) {
  EXPECT_DOUBLE_EQ(value_at(Asked::gap_at_peak, "", 0.0), 8e-3);
  EXPECT_DOUBLE_EQ(value_at(Asked::compact_height, "", 0.0), 8e-3 * 1.03);
  // A frame of 40 um/kN gives 1 mm, and its seats 0.15 * 40 um/kN * 3 kN = 18 um.
  double const stretch = 40e-9 * 25e3 + 18e-6 * (1.0 - std::exp(-25.0 / 3.0));
  EXPECT_NEAR(value_at(Asked::gap_at_peak, "frame_compliance", 40e-9), 8e-3 + stretch, 1e-12);
  EXPECT_NEAR(value_at(Asked::blank_travel, "frame_compliance", 40e-9), stretch, 1e-12);
  EXPECT_NEAR(value_at(Asked::opening_travel, "frame_compliance", 40e-9),
              stretch + 0.03 * (8e-3 + stretch), 1e-12);
  EXPECT_NEAR(value_at(Asked::compact_height, "gap_offset", 1e-3), 9e-3 * 1.03, 1e-12);
  EXPECT_NEAR(value_at(Asked::height_less_gap, "gap_offset", 1e-3), 9e-3 * 1.03 - 8e-3, 1e-12);
  EXPECT_NEAR(value_at(Asked::blank_zero, "gap_offset", 1e-3), -1e-3, 1e-12);
}

TEST(PressedHeight, PorosityIsMassOverDensityAgainstOuterDimensions) {
  double const wider = 1.0 + 0.15 * 0.03, height = 8e-3 * 1.03;
  auto const porosity = [&](double m, double d) {
    return 1.0 - m / 3600.0 / (std::numbers::pi / 4.0 * d * d * wider * wider * height);
  };
  EXPECT_NEAR(value_at(Asked::porosity, "", 0.0), porosity(mass, bore), 1e-12);
  EXPECT_NEAR(value_at(Asked::porosity, "mass_error", 0.02), porosity(1.02 * mass, bore), 1e-12);
  EXPECT_NEAR(value_at(Asked::porosity, "die_size", 0.1e-3), porosity(mass, bore + 0.1e-3), 1e-12);
}

TEST(PressedHeight, AMissingApproachIsCountedBackFromThePorosity) {
  reduced::PressedHeight const model(known(), {row(Asked::porosity)});
  double const wider = 1.0 + 0.15 * 0.02;
  double const porosity =
      1.0 - mass / density / (area * wider * wider * 9e-3 * 1.02); // 1 mm is missing
  auto const missing = missing_approach(model, 0, porosity, 1e-3);
  EXPECT_NEAR(missing.value, 1e-3, 1e-9);
  EXPECT_NEAR(missing.height, 9e-3 * 1.02, 1e-9);
  EXPECT_NEAR(missing.sole_density, density * 9.0 / 8.0, 1e-3);
  // Springback 1 %: 9 mm 0.01 (1/1.02 + 0.3/1.003) = 0.115 mm; density 2 %: 0.1765; gap 0.05; the
  // reading 9 mm 0.001 / 0.74 = 0.012; mass 0.009: 0.217 mm in all.
  EXPECT_NEAR(missing.sd, 0.217e-3, 0.001e-3);
  // sqrt(3) * 70 = 121 kg/m^3: 9 mm * 3500 / 3621 = 8.699, 9 mm * 3500 / 3379 = 9.323.
  EXPECT_NEAR(missing.least, 0.699e-3, 1e-6);
  EXPECT_NEAR(missing.most, 1.323e-3, 1e-6);
}

TEST(PressedHeight, FittingNumbersAreConsistent) {
  auto const finding = found({{25e3, 8.2e-3}});
  EXPECT_EQ(finding.verdict, "consistent");
  EXPECT_NE(finding.sentences.front().find("fit each other"), std::string::npos);
}

/// At one force a frame and a wrong zero are the same.
TEST(PressedHeight, OneForceLeavesFrameAndZeroUndecided) {
  auto const finding = found({{25e3, 9.0e-3 * 1.02}});
  EXPECT_EQ(finding.verdict, "undecided");
  EXPECT_TRUE(has(finding.group, "frame_compliance"));
  EXPECT_TRUE(has(finding.group, "gap_offset"));
  ASSERT_FALSE(finding.measurements.empty());
  EXPECT_TRUE(finding.measurements.front().is_enough);
  auto const* const offset = find_cause(finding, "gap_offset");
  ASSERT_NE(offset, nullptr);
  EXPECT_NEAR(offset->size(), 1e-3, 0.1e-3);
}

/// Half the force: a frame gives half, a zero all of it. Caliper 20 um, gap 20 um, springback
/// common.
TEST(PressedHeight, TwoForcesTellAFrameFromAZero) {
  auto const frame = found({{25e3, 9.0e-3 * 1.02}, {10e3, 8.4e-3 * 1.02}});
  EXPECT_EQ(frame.verdict, "named") << frame.sentences.back();
  ASSERT_FALSE(named_causes(frame).empty());
  EXPECT_EQ(named_causes(frame).front().name, "frame_compliance");
  EXPECT_NEAR(named_causes(frame).front().size(), 40e-9, 5e-9);
  auto const zero = found({{25e3, 9.0e-3 * 1.02}, {10e3, 9.0e-3 * 1.02}});
  EXPECT_EQ(zero.verdict, "named") << zero.sentences.back();
  ASSERT_FALSE(named_causes(zero).empty());
  EXPECT_EQ(named_causes(zero).front().name, "gap_offset");
}

/// Half the frame's share of the missing approach is the case's own frame.
TEST(PressedHeight, KnowsTheFrameOfTheCase) {
  auto half = known();
  half.nominal.machine.frame.stiffness = 50e6;
  reduced::PressedHeight const model(half, {row(Asked::compact_height)});
  auto const missing = missing_approach(model, 0, 9e-3 * 1.02, 20e-6);
  EXPECT_NEAR(missing.value, 0.5e-3, 1e-9); // 25 kN / (50 kN/mm) = 0.5 mm of the 1 mm
  EXPECT_EQ(missing.sole_density, 0.0);     // a height needs no density
  EXPECT_EQ(missing.least, missing.most);
}

TEST(PressedHeight, TakesOnlyNumbersThatSayAnythingOfTheHeight) {
  auto data = pressings({{25e3, 9e-3}});
  data.runs[0].scalars["compact_mass"] = {9.1e-3, 1e-6};
  auto const rows = reduced::height_rows(data);
  ASSERT_EQ(rows.rows.size(), 1u);
  EXPECT_EQ(rows.rows[0].time, 600.0); // 12 mm at 20 um/s
  ASSERT_EQ(rows.left_out.size(), 1u);
  EXPECT_NE(rows.left_out[0].find("compact_mass"), std::string::npos);
  EXPECT_THROW(reduced::measured_rows(data, measured::Role::fit), dem::InvalidInput);
}
