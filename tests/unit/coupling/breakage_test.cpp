#include "coupling/breakage.hpp"

#include "coupling/press_measures.hpp"
#include "coupling/record/restart_file.hpp"
#include "dem/step/crush.hpp"
#include "tests/regression/tiny_press.hpp"
#include "tests/support/near.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/world_builders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace coupling;
using dem::Vec3;
using support::ScratchFolder;

TEST(Fragments, LieInTheGrainAndTouchNotMoreThanTheyMust) {
  auto const& all = dem::fragments();
  double volume = 0.0;
  int touching = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(all[i].centre.norm() + all[i].radius, 1.0, 1e-15);
    volume += std::pow(all[i].radius, 3);
    for (std::size_t j = 0; j < i; ++j) {
      double const gap = (all[i].centre - all[j].centre).norm() - all[i].radius - all[j].radius;
      EXPECT_GT(gap, -1e-15);
      touching += gap < 1e-12 ? 1 : 0;
    }
  }
  EXPECT_EQ(touching, 12 + 24); // edges of the octahedron; three of its corners to each diagonal
  // 6 (sqrt(2) - 1)^3 + 8 0.230093^3
  EXPECT_NEAR(volume, 0.426407 + 0.097454, 2e-6);
}

TEST(Crush, KeepsMassMomentumAndWhatOthersRemember) {
  build::Recipe recipe;
  recipe.law.precision = dem::Precision::full;
  dem::World world = build::empty_world(recipe);
  double const R = 0.5e-3;
  for (int k = 0; k < 4; ++k) // a row that slides on itself
    world.grains.add(Vec3(0.95e-3 * k, 0, 0), R, 3500.0, 0, Vec3(0, 0.1 * k, 0), Vec3(0, 0, 30));
  dem::prepare(world);
  for (int k = 0; k < 5; ++k)
    dem::advance(world, 1e-7);
  auto const mass = [&] {
    return std::accumulate(world.grains.mass.begin(), world.grains.mass.end(), 0.0);
  };
  auto const momentum = [&] {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < world.grains.size(); ++i)
      sum += world.grains.mass[i] * world.grains.velocity[i];
    return sum;
  };
  auto const spring_force = [&] { // of the contact of grains 0 and 1
    for (dem::Contact const& c : dem::list_contacts(world))
      if (std::max(world.grains.id[c.i], world.grains.id[c.j]) == 1)
        return c.tangential_force.norm();
    return -1.0;
  };
  double const mass_before = mass(), spring_before = spring_force();
  Vec3 const momentum_before = momentum();
  std::uint32_t const row = static_cast<std::uint32_t>(build::row_of(world, 3));
  Vec3 const centre = world.grains.position[row];
  dem::Dust const dust = dem::crush(world, std::span(&row, 1), 7);
  EXPECT_EQ(world.grains.size(), 17u);
  EXPECT_TRUE(near::relative(mass() + dust.mass, mass_before, 1e-14));
  EXPECT_TRUE(near::relative(dust.mass, (1 - 0.5238612) * mass_before / 4, 1e-5));
  EXPECT_TRUE(near::relative(dust.volume, dust.mass / 3500.0, 1e-12));
  EXPECT_LT((momentum() + dust.momentum - momentum_before).norm(), 1e-13 * momentum_before.norm());
  EXPECT_GT(spring_before, 0.0);
  EXPECT_TRUE(near::relative(spring_force(), spring_before, 1e-12));
  for (std::uint32_t id = 3; id < 17; ++id) {
    std::size_t const i = build::row_of(world, id);
    EXPECT_LE((world.grains.position[i] - centre).norm() + world.grains.radius[i], R * (1 + 1e-12));
  }
}

/// A share exp(-(d/d_0)^3 (sigma/sigma_0)^m) survives.
TEST(Strength, IsDrawnFromWeibullsLaw) {
  BreakageLaw const law{.strength = 20e6, .weibull_modulus = 4.0, .reference_diameter = 1e-3};
  int const n = 20000;
  for (double const d : {1e-3, 2e-3})
    for (double const sigma : {8e6, 14e6, 20e6}) {
      int survivors = 0;
      for (std::uint32_t id = 0; id < n; ++id)
        survivors += strength_of(law, 5, id, d) > sigma ? 1 : 0;
      double const share = std::exp(-std::pow(d / 1e-3, 3) * std::pow(sigma / 20e6, 4));
      EXPECT_NEAR(survivors / double(n), share, 4.0 * std::sqrt(share * (1 - share) / n) + 1e-4);
    }
  EXPECT_EQ(strength_of(law, 5, 1, 1e-3), strength_of(law, 5, 1, 1e-3));
  EXPECT_NE(strength_of(law, 5, 1, 1e-3), strength_of(law, 6, 1, 1e-3));
}

TEST(Breakage, StressIsForceOverDiameterSquared) {
  build::Recipe const recipe = coupling::verification::smooth();
  dem::World world = build::empty_world(recipe);
  world.grains.add(Vec3::Zero(), 0.5e-3, 3500.0, 0);
  world.grains.add(Vec3(0.95e-3, 0, 0), 0.5e-3, 3500.0, 0);
  dem::prepare(world);
  double const force = std::abs(world.grains.force[0].x());
  EXPECT_GT(force, 0.0);
  for (double const stress : largest_stress(world))
    EXPECT_TRUE(near::relative(stress, force / 1e-6, 1e-12));
}

namespace {

// The tiny bed carries some 10 N over 28 mm^2 at most: contacts of grains, some 1e5 Pa d^2.
std::vector<std::string> const brittle{"Breakage/Strength=0.4 MPa", "Breakage/Weibull modulus=6",
                                       "Breakage/Smallest diameter=0.9 mm"};

} // namespace

TEST(Breakage, OfAPressKeepsItsBooks) {
  ScratchFolder scratch;
  Press whole = tiny::press(brittle);
  double const mass = whole.grain_mass;
  std::size_t const n = whole.world.grains.size();
  tiny::run(whole, scratch / "whole", "unloading");
  auto const broken = whole.tally.broken_grains;
  EXPECT_GT(broken, 3u);
  EXPECT_EQ(whole.world.grains.size(), n + 13 * broken);
  double const grains =
      std::accumulate(whole.world.grains.mass.begin(), whole.world.grains.mass.end(), 0.0);
  EXPECT_TRUE(near::relative(grains + whole.tally.dust_mass, mass, 1e-12));
  for (Check const& check : summarise(whole).checks)
    EXPECT_TRUE(check.ok) << check.name << ": " << check.value;
  auto const loss = whole.record.column("breakage_loss");
  EXPECT_GT(loss.back(), 0.0);
  // Grains of up to 0.9 mm are those of broken ones and do not break.
  EXPECT_GT(*std::ranges::min_element(whole.world.grains.radius), 0.22 * 0.5e-3);
  // The same bits from a restart in the midst of it.
  Press first = tiny::press(brittle);
  tiny::run(first, scratch / "part", "loading");
  EXPECT_GT(first.tally.broken_grains, 0u);
  Press second = restore_press(tiny::read(brittle), stage_restart(scratch / "part", "loading"));
  tiny::run(second, scratch / "part", "unloading");
  EXPECT_EQ(whole.record.rows(), second.record.rows());
}

TEST(Breakage, MakesTheBedYield) {
  ScratchFolder scratch;
  auto const peak = [&](std::vector<std::string> const& changes, char const* folder) {
    Press press = tiny::press(changes);
    tiny::run(press, scratch / folder, "loading");
    return summarise(press).max_force;
  };
  // A tiny bed packs differently each time: by 10 % of its peak.
  EXPECT_LT(peak(brittle, "brittle"), 0.7 * peak({}, "strong"));
}

TEST(Breakage, DustLiesInThePores) {
  ScratchFolder scratch;
  Press press = tiny::press(brittle);
  tiny::run(press, scratch.path(), "unloading");
  double const seen = press.tally.porosity;
  press.tally.dust_volume *= 2.0;
  measure_compact(press);
  double volume = 0.0;
  for (double const radius : press.world.grains.radius)
    volume += dem::sphere_volume(radius);
  double const dust = 0.5 * press.tally.dust_volume;
  EXPECT_TRUE(near::relative(1.0 - press.tally.porosity,
                             (1.0 - seen) * (volume + 2.0 * dust) / (volume + dust), 1e-12));
}
