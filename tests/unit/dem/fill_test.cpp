#include "dem/packing/fill.hpp"

#include "dem/expect.hpp"
#include "dem/packing/random_stream.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace dem {
namespace {

constexpr FillVolume seed_volume{.radius = 11.025e-3, .height = 20e-3};

std::vector<GrainShare> seed_shares(double alumina_diameter = 0.5e-3) {
  return {{0.5e-3, 3500.0, 0, 0, 0.8 * 0.35},
          {1e-3, 3500.0, 0, 0, 0.8 * 0.25},
          {2e-3, 3500.0, 0, 0, 0.8 * 0.25},
          {3e-3, 3500.0, 0, 0, 0.8 * 0.15},
          {alumina_diameter, 3000.0, 1, 1, 0.2}};
}

/// Smallest gap over the sum of the radii, by comparing all pairs that are near along z: knows
/// nothing of cells.
double smallest_gap(Packing grains) {
  std::ranges::sort(grains, {}, [](PackedGrain const& grain) { return grain.position[2]; });
  double largest = 0.0;
  for (PackedGrain const& grain : grains)
    largest = std::max(largest, grain.diameter);
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < grains.size(); ++i)
    for (std::size_t j = i + 1; j < grains.size(); ++j) {
      double const reach = 0.5 * (grains[i].diameter + largest);
      if (grains[j].position[2] - grains[i].position[2] > reach)
        break;
      double const sum = 0.5 * (grains[i].diameter + grains[j].diameter);
      double const distance = (grains[i].position - grains[j].position).norm();
      smallest = std::min(smallest, distance / sum - 1.0);
    }
  return smallest;
}

double smallest_wall_gap(Packing const& grains, FillVolume const& volume) {
  double smallest = std::numeric_limits<double>::infinity();
  for (PackedGrain const& grain : grains) {
    double const R = 0.5 * grain.diameter, z = grain.position[2];
    double const bore = volume.radius - volume.wall_clearance - grain.position.head<2>().norm();
    smallest = std::min({smallest, bore - R, z - R, volume.height - z - R});
  }
  return smallest;
}

// Expected: nearest counts of 9.13 g: 3 mm 22.14, 2 mm 124.55, 1 mm 996.4; 0.5 mm MgO is what 7.304
// g still lack, 2.557578 mg / 0.229074 mg = 11164.8; alumina what 9.13 g lack, 1.825963 g /
// 0.1963495 mg = 9299.5 and up.
TEST(GrainCounts, GiveTheSeedPowderOfTheLiggghtsRuns) {
  auto const classes = count_grains(seed_shares(), 9.13e-3);
  EXPECT_EQ(classes[0].count, 11165u);
  EXPECT_EQ(classes[1].count, 996u);
  EXPECT_EQ(classes[2].count, 125u);
  EXPECT_EQ(classes[3].count, 22u);
  EXPECT_EQ(classes[4].count, 9300u);
  EXPECT_NEAR(total_mass(classes), 9.1301e-3, 5e-8);
  EXPECT_NEAR(solid_volume(classes), 2.69555e-6, 5e-12);
}

TEST(GrainCounts, MeetTheMassWithinHalfOfTheLightestGrain) {
  for (double alumina : {0.5e-3, 0.3e-3, 0.15e-3})
    for (double mass : {9.13e-3, 2.2825e-3, 1.234567e-3}) {
      auto const classes = count_grains(seed_shares(alumina), mass);
      EXPECT_LE(std::abs(total_mass(classes) - mass), 0.5001 * grain_mass(classes[4]));
      double magnesia = 0.0;
      for (std::size_t k = 0; k < 4; ++k) {
        magnesia += grain_mass(classes[k]) * static_cast<double>(classes[k].count);
        if (k == 0)
          continue;
        double const wanted = seed_shares()[k].mass_fraction * mass / grain_mass(classes[k]);
        EXPECT_LE(std::abs(static_cast<double>(classes[k].count) - wanted), 0.5001);
      }
      EXPECT_LE(std::abs(magnesia - 0.8 * mass), 0.5001 * grain_mass(classes[0]));
    }
}

// 1.6 large grains round to 2, but then 0.4 of a large grain's mass is too much for fines that
// share 0.1: round down.
TEST(GrainCounts, RoundHeavyClassesDownWhereTheFinesCannotPay) {
  double const large = 1000.0 * sphere_volume(1e-3);
  std::vector<GrainShare> const shares{{2e-3, 1000.0, 0, 0, 1.6 / 1.7},
                                       {0.2e-3, 1000.0, 0, 0, 0.1 / 1.7}};
  auto const classes = count_grains(shares, 1.7 * large);
  EXPECT_EQ(classes[0].count, 1u);
  EXPECT_EQ(classes[1].count, 700u); // 0.7 large grains at 1000 fines each
}

TEST(GrainCounts, RefuseSharesThatDoNotSumToOneAndNoMass) {
  auto shares = seed_shares();
  EXPECT_THROW(count_grains(shares, 0.0), InvalidInput);
  EXPECT_THROW(count_grains(shares, std::nan("")), InvalidInput);
  EXPECT_THROW(count_grains(shares, 1e-11), InvalidInput);
  shares[4].mass_fraction = 0.3;
  EXPECT_THROW(count_grains(shares, 9.13e-3), InvalidInput);
}

// The C++ standard, [rand.predef]: the 10000th value of a mt19937_64 with the default seed 5489 is
// 9981545732273789042.
TEST(RandomStream, IsTheStandardsEngineWithFiftyThreeBits) {
  RandomStream random(5489);
  for (int n = 1; n < 10000; ++n)
    random.uniform();
  EXPECT_EQ(random.uniform(), static_cast<double>(9981545732273789042u >> 11) / 9007199254740992.0);
}

TEST(Fill, PlacesTheSeedPowderFreeOfContacts) {
  auto const classes = count_grains(seed_shares(), 9.13e-3);
  Packing const grains = fill_cylinder(classes, seed_volume, 1);
  EXPECT_GE(smallest_gap(grains), 0.9 * packing_clearance);
  EXPECT_GE(smallest_wall_gap(grains, seed_volume), 0.0);
  for (GrainClass const& each : classes)
    EXPECT_EQ(std::ranges::count_if(grains,
                                    [&](PackedGrain const& grain) {
                                      return grain.diameter == each.diameter &&
                                             grain.component == each.component;
                                    }),
              static_cast<std::ptrdiff_t>(each.count));
}

TEST(Fill, ReachesFortyFivePercentByMakingRoom) {
  // 2.69555 cm3 of grains in 15.68 mm of bore are 45.0 %: random sequential insertion alone stops
  // near 38 %.
  FillVolume const volume{.radius = 11.025e-3, .height = 15.68e-3};
  auto const classes = count_grains(seed_shares(), 9.13e-3);
  Packing const grains = fill_cylinder(classes, volume, 3);
  EXPECT_EQ(grains.size(), 21608u);
  EXPECT_GE(smallest_gap(grains), 0.9 * packing_clearance);
  EXPECT_GE(smallest_wall_gap(grains, volume), 0.0);
}

TEST(Fill, PlacesGrainsTwentyTimesFinerThanTheLargest) {
  FillVolume const volume{.radius = 4e-3, .height = 8e-3, .wall_clearance = 1e-5};
  std::vector<GrainClass> const classes{{3e-3, 3500.0, 0, 0, 3}, {0.15e-3, 3000.0, 1, 1, 20000}};
  Packing const grains = fill_cylinder(classes, volume, 5);
  EXPECT_GE(smallest_gap(grains), 0.9 * packing_clearance);
  EXPECT_GE(smallest_wall_gap(grains, volume), 0.0);
}

TEST(Fill, RepeatsItsBitsForASeedAndDiffersForAnother) {
  auto const classes = count_grains(seed_shares(), 9.13e-4);
  FillVolume const volume{.radius = 5e-3, .height = 8e-3}; // 43 %: includes the relaxation
  Packing const first = fill_cylinder(classes, volume, 7);
  Packing const again = fill_cylinder(classes, volume, 7);
  Packing const other = fill_cylinder(classes, volume, 8);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].position, again[i].position);
    EXPECT_EQ(first[i].component, again[i].component);
    EXPECT_NE(first[i].position, other[i].position);
  }
}

// Dilute grains (1 %) are uniform over the cylinder their centres can reach: mean z is its middle,
// with standard error height / sqrt(12 n); r^2 is uniform in 0 .. room^2. Four standard errors.
TEST(Fill, IsUniformInTheCylinder) {
  std::uint64_t const n = 15000;
  std::vector<GrainClass> const classes{{0.2e-3, 3000.0, 0, 0, n}};
  Packing const grains = fill_cylinder(classes, seed_volume, 11);
  Vec3 mean = Vec3::Zero();
  double mean_squared_radius = 0.0;
  for (PackedGrain const& grain : grains) {
    mean += grain.position / n;
    mean_squared_radius += grain.position.head<2>().squaredNorm() / n;
  }
  double const four_errors = 4.0 / std::sqrt(12.0 * n), room = 11.025e-3 - 0.1e-3;
  EXPECT_NEAR(mean[2], 10e-3, four_errors * 19.8e-3);
  EXPECT_NEAR(mean_squared_radius, 0.5 * room * room, four_errors * room * room);
  // x of a uniform disc has variance room^2 / 4
  EXPECT_NEAR(mean[0], 0.0, 4.0 * 0.5 * room / std::sqrt(n));
  EXPECT_NEAR(mean[1], 0.0, 4.0 * 0.5 * room / std::sqrt(n));
}

// Components of one size mix: their mean places in the order of insertion agree within four
// standard errors.
TEST(Fill, MixesComponentsOfOneSize) {
  std::vector<GrainClass> const classes{{0.5e-3, 3500.0, 0, 0, 3000}, {0.5e-3, 3000.0, 1, 1, 2000}};
  Packing const grains = fill_cylinder(classes, seed_volume, 2);
  double mean_row = 0.0;
  for (std::size_t i = 0; i < grains.size(); ++i)
    if (grains[i].component == 1)
      mean_row += static_cast<double>(i) / 2000.0;
  EXPECT_NEAR(mean_row, 2499.5, 4.0 * 5000.0 / std::sqrt(12.0 * 2000.0));
}

TEST(Fill, SaysByHowMuchThePowderDoesNotFit) {
  auto const classes = count_grains(seed_shares(), 20e-3);
  try {
    fill_cylinder(classes, seed_volume, 1);
    FAIL() << "77 % solid cannot lie free";
  } catch (InvalidInput const& error) {
    std::string const message = error.what();
    EXPECT_NE(message.find("77.3"), std::string::npos) << message; // 20/9.13 of 35.294 % = 77.31 %
    EXPECT_NE(message.find("fill height to 34.36"), std::string::npos) << message; // 20 mm 77.31/45
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(Fill, RefusesAGrainLargerThanTheBoreOrTheHeight) {
  std::vector<GrainClass> const classes{{3e-3, 3500.0, 0, 0, 1}};
  EXPECT_THROW(fill_cylinder(classes, {.radius = 1.5e-3, .height = 20e-3}, 1), InvalidInput);
  EXPECT_THROW(fill_cylinder(classes, {.radius = 11e-3, .height = 2.9e-3}, 1), InvalidInput);
  EXPECT_THROW(
      fill_cylinder(classes, {.radius = 1.505e-3, .height = 20e-3, .wall_clearance = 1e-5}, 1),
      InvalidInput);
  EXPECT_EQ(fill_cylinder(classes, {.radius = 1.505e-3, .height = 20e-3}, 1).size(), 1u);
}

} // namespace
} // namespace dem
