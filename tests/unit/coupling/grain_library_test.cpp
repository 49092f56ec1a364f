#include "coupling/case.hpp"
#include "coupling/record/atomic_file.hpp"
#include "coupling/record/curves.hpp"
#include "coupling/reduced/bed_law.hpp"
#include "coupling/reduced/grain_library.hpp"
#include "dem/expect.hpp"
#include "tests/support/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace coupling;
using namespace coupling::reduced;

namespace {

BedLaw const law{.stiffness = 400e6,
                 .cohesion = 18e6,
                 .onset = 0.63,
                 .exponent = 1.6,
                 .recovery = 0.95,
                 .wall_friction = 0.17,
                 .radial_ratio = 0.53,
                 .opening = 2.6};
Bed const bed{.solid_area = 7.0589e-3, .bore = 22.05e-3}; // of the default case

/// curves.csv of a press cycle on a law, with a dwell at the end.
std::string curves(BedLaw const& of) {
  std::string text = "time [s],stage,bed_height [m],upper_punch_force [N],lower_punch_force [N],"
                     "wall_radial_pressure [Pa]\n";
  double time = 0.0;
  auto const record = [&](char const* stage, double height, double smallest) {
    auto const forces = bed_forces(of, bed, height, smallest);
    text += fmt::format("{},{},{},{},{},{}\n", time += 1e-3, stage, height, forces.upper,
                        forces.lower, forces.radial_pressure);
  };
  for (int k = 0; k <= 100; ++k)
    record("loading", 12e-3 - 4e-5 * k, 12e-3 - 4e-5 * k);
  for (int k = 1; k <= 100; ++k)
    record("unloading", 8e-3 + 4e-5 * k, 8e-3);
  record("release", 12e-3, 8e-3);
  return text;
}

void write_run(std::filesystem::path const& study, std::string const& name, int seed,
               std::string const& entries, BedLaw const& of) {
  auto const folder = study / "runs" / name;
  std::filesystem::create_directories(folder);
  write_file(folder / "case.resolved.prm",
             fmt::format("subsection Powder\n  set Packing seed = {}\nend\n{}", seed, entries));
  write_file(folder / "curves.csv", curves(of));
  write_file(folder / "summary.json", "{}");
}

std::string wall(double mu) {
  return fmt::format(
      "subsection Contact\n  subsection Particle-wall\n    set Coefficient of static "
      "friction = {}\n  end\nend\n",
      mu);
}

BedLaw with_wall(double change) {
  return changed(law, {0, 0, 0, 0, 0, 0, change, 0});
}

} // namespace

TEST(GrainLibrary, TellsFactorsAndSeedsFromTheCases) {
  support::ScratchFolder const study;
  for (int seed : {1, 2}) {
    auto const end = seed == 1 ? std::string() : "_r2";
    write_run(study.path(), "base" + end, seed, "", law);
    write_run(study.path(), "less" + end, seed, wall(0.15), with_wall(-0.04));
    write_run(study.path(), "more" + end, seed, wall(0.25), with_wall(0.04));
  }
  auto const library = read_library(study.path());
  EXPECT_EQ(library.n_runs, 6u);
  ASSERT_EQ(library.effects.size(), 1u);
  EXPECT_EQ(library.effects[0].factor, "wall_friction");
  EXPECT_DOUBLE_EQ(library.effects[0].middle, 0.2);
  EXPECT_NEAR(library.effects[0].slope[6], 0.8, 0.01);
  EXPECT_NEAR(library.effects[0].error[6], 0.0, 1e-9);
  EXPECT_NEAR(library.middle.stiffness, 400e6, 2e6);
  EXPECT_NEAR(library.middle.wall_friction, 0.17, 1e-3);
  EXPECT_TRUE(library.plastic.empty());
}

TEST(GrainLibrary, RefusesRunsOfAnotherStudy) {
  support::ScratchFolder const study;
  EXPECT_THROW(read_library(study.path()), dem::InvalidInput);
  for (int seed : {1, 2})
    write_run(study.path(), fmt::format("base_r{}", seed), seed, "", law);
  write_run(study.path(), "again", 3, "", law); // changes nothing
  EXPECT_THROW(read_library(study.path()), dem::InvalidInput);
}

/// V / A = 9.13e-3 (0.8 / 3500 + 0.2 / 3000) / (pi 22.05e-3^2 / 4) = 7.0589e-3 m
TEST(SimulatedCycle, BedOfACase) {
  Case setup;
  setup.powder.components.resize(2);
  setup.powder.components[0].mass_fraction = 0.8;
  setup.powder.components[0].material.density = 3500.0;
  setup.powder.components[1].mass_fraction = 0.2;
  setup.powder.components[1].material.density = 3000.0;
  EXPECT_NEAR(bed_of(setup).solid_area, 7.05888e-3, 1e-8);
  EXPECT_EQ(bed_of(setup).bore, 22.05e-3);
}

TEST(SimulatedCycle, IsReadFromCurves) {
  auto const cycle = cycle_of(parse_curves(curves(law), "curves.csv"));
  auto const parts = parts_of(cycle);
  EXPECT_EQ(parts.turn, 100u);
  EXPECT_EQ(parts.loading.back(), 100u);
  EXPECT_GT(parts.loading.size(), 50u);    // those that bear
  EXPECT_EQ(parts.unloading.size(), 100u); // without the release, which does not open
  try {
    cycle_of(parse_curves("time [s],bed_height [m]\n0,1\n", "curves.csv"));
    FAIL();
  } catch (dem::InvalidInput const& error) {
    EXPECT_STREQ(error.what(),
                 "simulated cycle: the record has no column upper_punch_force (a bed law needs "
                 "heights, both forces and the radial pressure). Was it a measured curve?");
  }
}
