#include "coupling/record/atomic_file.hpp"
#include "coupling/reduced/bed_fit.hpp"
#include "coupling/reduced/grain_library.hpp"
#include "dem/expect.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace coupling::reduced;

namespace {

Bed const bed{.solid_area = 7e-3, .bore = 22e-3};

SimulatedCycle pressed(BedLaw const& law) {
  SimulatedCycle cycle;
  auto const record = [&](double height, double smallest) {
    auto const forces = bed_forces(law, bed, height, smallest);
    cycle.height.push_back(height);
    cycle.upper.push_back(forces.upper), cycle.lower.push_back(forces.lower);
    cycle.radial_pressure.push_back(forces.radial_pressure);
  };
  for (int k = 0; k <= 100; ++k)
    record(12e-3 - 4e-5 * k, 12e-3 - 4e-5 * k);
  for (int k = 1; k <= 100; ++k)
    record(8e-3 + 4e-5 * k, 8e-3);
  return cycle;
}

BedLaw const middle{.stiffness = 400e6,
                    .cohesion = 18e6,
                    .onset = 0.63,
                    .exponent = 1.6,
                    .recovery = 0.95,
                    .wall_friction = 0.19,
                    .radial_ratio = 0.53,
                    .opening = 2.6};

/// A cycle with its own law, as the library has them.
BedLaw fitted() {
  return fit_bed_law(pressed(middle), bed).law;
}

} // namespace

TEST(GrainEffects, ChangeEachNumber) {
  BedLaw const law = changed(middle, {0.1, 0.2, 0.01, 0.03, -0.02, 0.3, 0.04, -0.05});
  EXPECT_NEAR(law.stiffness, 400e6 * std::exp(0.1), 1.0);
  EXPECT_NEAR(law.cohesion, 18e6 * std::exp(0.2), 1.0);
  EXPECT_NEAR(law.onset, 0.64, 1e-12);
  EXPECT_NEAR(law.exponent, 1.63, 1e-12);
  EXPECT_NEAR(law.recovery, 0.93, 1e-12);
  EXPECT_NEAR(law.opening, 2.6 * std::exp(0.3), 1e-12);
  EXPECT_NEAR(law.wall_friction, 0.23, 1e-12);
  EXPECT_NEAR(law.radial_ratio, 0.48, 1e-12);
  EXPECT_EQ(changed(middle, {0, 0, 0, 0, 0, 0, -1.0, 0}).wall_friction, 0.0);
}

/// K, S, phi_c and n share what one of them did, so the curve is what comes back; the others do.
TEST(GrainEffects, FindTheChangeOfALaw) {
  BedLaw const base = fitted();
  BedNumbers const put{0.08, 0.1, 0.003, 0.02, 0.03, 0.1, 0.02, -0.03};
  BedLaw const other = changed(base, put);
  auto const found = change_of_numbers(base, pressed(other), bed);
  BedLaw const back = changed(base, found);
  double const peak = other.loading(0.875);
  for (double const phi : {0.68, 0.72, 0.78, 0.875})
    EXPECT_NEAR(back.loading(phi), other.loading(phi), 2e-3 * peak) << phi;
  // r and p are of the way to the onset that was found: the curve is what comes back.
  for (double const phi : {0.86, 0.8, 0.75})
    EXPECT_NEAR(back.unloading_stress(phi, 0.875) / back.loading(0.875),
                other.unloading_stress(phi, 0.875) / other.loading(0.875), 5e-3);
  EXPECT_NEAR(found[6], 0.02, 5e-4);
  EXPECT_NEAR(found[7], -0.03, 5e-4);
  auto const nothing = change_of_numbers(base, pressed(base), bed);
  for (double const number : nothing)
    EXPECT_NEAR(number, 0.0, 1e-3);
}

TEST(GrainEffects, FindYieldingContacts) {
  BedLaw const base = fitted();
  BedLaw plastic = base;
  plastic.yielding = {0.25, 7e6};
  plastic.opening *= 1.2;
  auto const found = plastic_change(base, pressed(plastic), bed);
  EXPECT_NEAR(found.yielding.size, 0.25, 2e-3);
  EXPECT_NEAR(found.yielding.stress, 7e6, 0.1e6);
  EXPECT_NEAR(found.recovery, 0.0, 2e-3);
  EXPECT_NEAR(found.ln_opening, std::log(1.2), 1e-2);
}

/// Two seeds whose slopes of mu are 0.8 and 1.0: mean 0.9, standard error 0.1.
TEST(GrainEffects, AreMeansOverSeedsWithTheirScatter) {
  BedLaw const base = fitted();
  auto const at = [&](double change) {
    return pressed(changed(base, {0, 0, 0, 0, 0, 0, change, 0}));
  };
  std::vector<PairedCycles> const seeds{{at(-0.04), at(0.0), at(0.04)},
                                        {at(-0.05), at(0.0), at(0.05)}};
  GrainEffect asked{};
  asked.factor = "wall_friction", asked.measure = "coefficient [1]";
  asked.low = 0.15, asked.middle = 0.2, asked.high = 0.25;
  auto const effect = measure_effect(asked, seeds, bed);
  EXPECT_EQ(effect.n_seeds, 2u);
  EXPECT_NEAR(effect.slope[6], 0.9, 0.01);
  EXPECT_NEAR(effect.error[6], 0.1, 0.01);
  EXPECT_GT(effect.before, 5.0 * effect.after);
  EXPECT_THROW(measure_effect(asked, std::span(seeds).first(1), bed), dem::InvalidInput);
  asked.high = 0.1;
  EXPECT_THROW(measure_effect(asked, seeds, bed), dem::InvalidInput);
}

TEST(GrainEffects, AreWrittenAndRead) {
  GrainLibrary library{};
  library.effects.push_back({.factor = "cohesion",
                             .measure = "ln CED",
                             .low = 14.5,
                             .middle = 14.9,
                             .high = 15.2,
                             .n_seeds = 4,
                             .slope = {1, 2, 3, 4, 5, 6, 7, 8},
                             .error = {8, 7, 6, 5, 4, 3, 2, 1},
                             .before = 0.02,
                             .after = 0.01});
  support::ScratchFolder const folder;
  auto const file = folder.path() / "effects.json";
  coupling::write_file(file, library_json(library, "command"));
  auto const read = read_effects(file);
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].factor, "cohesion");
  EXPECT_EQ(read[0].slope, library.effects[0].slope);
  EXPECT_EQ(read[0].error, library.effects[0].error);
  EXPECT_EQ(read[0].n_seeds, 4u);
  EXPECT_EQ(read[0].after, 0.01);
  coupling::write_file(file, "{}");
  EXPECT_THROW(read_effects(file), dem::InvalidInput);
}

/// The table that is kept beside the study can be read, and says what it must about friction: more
/// on the wall makes the wall's coefficient larger, stiffer grains a stiffer bed.
TEST(GrainEffects, KeptTableIsSound) {
  auto const effects =
      read_effects(std::string(PRESSCHECK_SOURCE_DIR) + "/cases/seed-library/grain_effects.json");
  ASSERT_EQ(effects.size(), 4u);
  EXPECT_EQ(effects[1].factor, "wall_friction");
  EXPECT_GT(effects[1].slope[6], 5.0 * effects[1].error[6]);
  EXPECT_EQ(effects[2].factor, "young_modulus");
  EXPECT_NEAR(effects[2].slope[0], 1.0, 0.2); // K is proportional to E
  for (auto const& effect : effects)
    EXPECT_LT(effect.after, effect.before) << effect.factor;
}
