// How far an entry goes, found by simulations: here formulas stand for them.
#include "coupling/finding/dose_search.hpp"

#include "coupling/finding/bed_facts.hpp"
#include "coupling/record/curves.hpp"
#include "coupling/record/run_file.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace coupling::finding {
namespace {

struct Tries {
  std::vector<double> doses = {};
  FoundDose found;
};

template <class Effect> Tries searched(Dose dose, Effect effect, DoseSearch search = {}) {
  Tries tries;
  tries.found = search_dose(dose, search, [&](double at) {
    tries.doses.push_back(at);
    return effect(at);
  });
  return tries;
}

TEST(DoseSearch, AProportionTakesTwo) {
  auto const [doses, found] = searched({1.0, 100.0}, [](double x) { return 0.4 * x; });
  EXPECT_EQ(doses, (std::vector<double>{1.0, 2.5}));
  EXPECT_TRUE(found.is_reached);
  EXPECT_EQ(found.n_simulations, 2);
  EXPECT_EQ(found.dose, 2.5);
  EXPECT_EQ(found.effect, 1.0);
  EXPECT_EQ(in_words(found), "by 2 simulations, the nearest of which shows 1.00 of the effect");
}

TEST(DoseSearch, AGoodGuessTakesOneAndTooMuchGoesBack) {
  EXPECT_EQ(searched({2.0, 100.0}, [](double x) { return 0.49 * x; }).doses.size(), 1u);
  auto const [doses, found] = searched({3.0, 100.0}, [](double x) { return x; });
  EXPECT_EQ(doses, (std::vector<double>{3.0, 1.0}));
  EXPECT_TRUE(found.is_reached);
}

/// Grains that are crushed: ever less for the same.
TEST(DoseSearch, FollowsAnEffectThatLevelsOff) {
  auto const [doses, found] =
      searched({1.0, 1e6}, [](double x) { return 1.5 * -std::expm1(-0.4 * x); });
  EXPECT_TRUE(found.is_reached) << found.effect;
  EXPECT_LE(doses.size(), 4u);
  EXPECT_NEAR(found.effect, 1.0, 0.05);
}

/// And one that sets in late, which is passed and bracketed.
TEST(DoseSearch, FollowsAnEffectThatSetsInLate) {
  auto const [doses, found] =
      searched({1.0, 1e6}, [](double x) { return 0.02 * x * x * x; }, {.most_simulations = 6});
  EXPECT_EQ(doses[1], 4.0) << "at most four times the last";
  EXPECT_TRUE(found.is_reached) << found.effect;
}

TEST(DoseSearch, EndsAtTheLargestDoseAndSaysSo) {
  auto const [doses, found] = searched({0.5, 1.0}, [](double x) { return 0.3 * x; });
  EXPECT_EQ(doses, (std::vector<double>{0.5, 1.0}));
  EXPECT_FALSE(found.is_reached);
  EXPECT_EQ(found.effect, 0.3);
  EXPECT_EQ(in_words(found),
            "by 2 simulations, the nearest of which shows 0.30 of the effect: not reached");
  EXPECT_EQ(searched({7.0, 1.0}, [](double x) { return 0.3 * x; }).doses.size(), 1u)
      << "a guess beyond the largest";
}

/// What a packing scatters by may point the other way.
TEST(DoseSearch, GoesOnWhereNothingIsSeenAndKeepsTheNearest) {
  auto const [doses, found] = searched({1.0, 1e6}, [](double) { return -0.01; });
  EXPECT_EQ(doses, (std::vector<double>{1.0, 4.0, 16.0, 64.0}));
  EXPECT_EQ(found.dose, 1.0);
  EXPECT_FALSE(found.is_reached);
}

TEST(DoseSearch, EndsWithWhatItHasWhereASimulationFails) {
  auto const none = searched({2.0, 100.0}, [](double) { return std::optional<double>(); });
  EXPECT_EQ(none.found.dose, 2.0);
  EXPECT_EQ(in_words(none.found), "a first guess, whose simulation failed");
  auto const one =
      searched({1.0, 100.0}, [](double x) { return x < 2.0 ? std::optional(0.4) : std::nullopt; });
  EXPECT_EQ(one.doses, (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(one.found.dose, 1.0);
  EXPECT_EQ(in_words(one.found),
            "by 1 simulation, the nearest of which shows 0.40 of the effect: not reached");
}

PressRecord cycle() {
  PressRecord record({{"time", "s"}, {"upper_punch_force", "N"}, {"mean_overlap", "m"}});
  record.add_row("press", {0.00, 0.0, 0.0});
  record.add_row("press", {0.01, 70.0, 1e-5});
  record.add_row("press", {0.02, 90.0, 4e-5});
  record.add_row("press", {0.03, 100.0, 5e-5});
  record.add_row("open", {0.04, 20.0, 2e-5});
  return record;
}

TEST(BedFacts, AreThoseOfTheLargestForce) {
  support::ScratchFolder const folder;
  support::put_bytes(folder.path() / "case.resolved.prm",
                     "subsection Tooling\n  set Bore diameter = 22.05 mm\nend\n");
  write_curves(folder.path() / "curves.csv", cycle());
  auto const alone = bed_facts(folder.path());
  EXPECT_TRUE(std::isnan(alone.relative_overlap)) << "no grains, no radius";
  // From the last row below four fifths.
  EXPECT_NEAR(alone.growth_time, 100.0 * 0.02 / 30.0, 1e-12);
  EXPECT_NEAR(alone.largest_stress, 100.0 / (0.25 * std::numbers::pi * 22.05e-3 * 22.05e-3), 1e-6);
  dem::Spheres grains;
  grains.add({0.0, 0.0, 0.0}, 2e-3, 1000.0, 0);
  grains.add({0.0, 0.0, 1.0}, 1e-3, 1000.0, 0);
  write_grain_frame(folder.path() / "run.h5", 0.04, "open", grains);
  // R* = r / 2 of two grains of the mean radius 1.5 mm.
  EXPECT_NEAR(bed_facts(folder.path()).relative_overlap, 5e-5 / 0.75e-3, 1e-12);
}

} // namespace
} // namespace coupling::finding
