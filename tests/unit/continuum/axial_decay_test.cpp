// The slab of Janssen and Walker. Reference numbers: powder.md 1.2.
#include "continuum/powder/axial_decay.hpp"
#include "tests/support/near.hpp"
#include "tests/unit/continuum/refusal.hpp"

#include <cmath>
#include <numbers>

namespace {

using namespace continuum;

AxialDecay seed(double mu, double K) {
  return {.diameter = 22.05e-3, .height = 9.4e-3, .wall_friction = mu, .lateral_ratio = K};
}

TEST(AxialDecay, TransmissionOfTheSeedCompact) {
  EXPECT_NEAR(seed(0.2, 0.4).transmission(), 0.87, 5e-3);
  EXPECT_NEAR(seed(0.2, 0.5).transmission(), 0.84, 5e-3);
  EXPECT_NEAR(seed(0.3, 0.5).transmission(), 0.77, 5e-3);
  EXPECT_TRUE(near::relative(seed(0.3, 0.5).transmission(),
                             std::exp(-4.0 * 0.3 * 0.5 * 9.4 / 22.05), 1e-14));
}

TEST(AxialDecay, MeanStressAndWallForce) {
  auto const bed = seed(0.3, 0.5);
  double const x = bed.exponent(), top = 65.7e6;
  EXPECT_TRUE(near::relative(bed.mean_stress(top), top * (1.0 - std::exp(-x)) / x, 1e-13));
  double const area = std::numbers::pi * 22.05e-3 * 22.05e-3 / 4.0;
  EXPECT_TRUE(near::relative(bed.wall_force(top), (top - bed.bottom_stress(top)) * area, 1e-14));
  // The wall's force is mu K_0 times the mean stress on the wall's area.
  EXPECT_TRUE(near::relative(
      bed.wall_force(top), 0.3 * 0.5 * bed.mean_stress(top) * std::numbers::pi * 22.05e-3 * 9.4e-3,
      1e-12));
}

// ds/dz = rho g - k s by differences, and the mean by Simpson's rule.
TEST(AxialDecay, WeightObeysTheSlabsBalance) {
  AxialDecay const silo{.diameter = 0.5,
                        .height = 3.0,
                        .wall_friction = 0.4,
                        .lateral_ratio = 0.5,
                        .bulk_density = 1500.0};
  double const top = 2e3, k = silo.exponent() / 3.0, h = 1e-4;
  for (double const z : {0.1, 1.0, 2.9}) {
    double const slope = (silo.stress_at(z + h, top) - silo.stress_at(z - h, top)) / (2.0 * h);
    EXPECT_TRUE(near::relative(slope, 1500.0 * 9.80665 - k * silo.stress_at(z, top), 1e-5));
  }
  double sum = 0.0;
  constexpr int n = 200;
  for (int i = 0; i <= n; ++i)
    sum += (i == 0 || i == n ? 1.0 : i % 2 ? 4.0 : 2.0) * silo.stress_at(3.0 * i / n, top);
  EXPECT_TRUE(near::relative(silo.mean_stress(top), sum / (3.0 * n), 1e-8));
  // Deep down the wall bears all: rho g D/(4 mu K).
  EXPECT_TRUE(near::relative(silo.stress_at(20.0, top), 1500.0 * 9.80665 * 0.5 / 0.8, 1e-6));
  EXPECT_TRUE(near::relative(silo.wall_force(top),
                             0.4 * 0.5 * silo.mean_stress(top) * std::numbers::pi * 0.5 * 3.0,
                             1e-12));
}

TEST(AxialDecay, SmoothWallIsTheLimit) {
  AxialDecay smooth = seed(0.0, 0.5), nearly = seed(1e-9, 0.5);
  smooth.bulk_density = nearly.bulk_density = 2000.0;
  EXPECT_EQ(smooth.stress_at(5e-3, 1e3), 1e3 + 2000.0 * 9.80665 * 5e-3);
  EXPECT_EQ(smooth.mean_stress(1e3), 1e3 + 2000.0 * 9.80665 * 4.7e-3);
  EXPECT_TRUE(near::relative(nearly.mean_stress(1e3), smooth.mean_stress(1e3), 1e-8));
  EXPECT_NEAR(smooth.wall_force(1e6), 0.0, 1e-9);
}

TEST(AxialDecay, FrictionFromAnInstrumentedDie) {
  auto const bed = seed(0.25, 0.45);
  double const top = 50e6, level = 3e-3; // from the fixed punch
  double const radial = 0.45 * bed.stress_at(9.4e-3 - level, top);
  EXPECT_NEAR(wall_friction_of(22.05e-3, 9.4e-3, top, bed.bottom_stress(top), radial, level), 0.25,
              1e-13);
}

TEST(AxialDecay, Refusals) {
  auto const refuse = [](auto const& spoil, std::string const& part) {
    auto bed = seed(0.2, 0.5);
    spoil(bed);
    expect_refusal([&] { bed.validate("bed"); }, part);
  };
  refuse([](auto& b) { b.diameter = 0.0; }, "bed: diameter = 0 m");
  refuse([](auto& b) { b.wall_friction = -0.1; }, "wall friction = -0.1");
  refuse([](auto& b) { b.lateral_ratio = -1.0; }, "lateral ratio = -1");
  refuse([](auto& b) { b.bulk_density = -1.0; }, "bulk density = -1");
  expect_refusal([] { wall_friction_of(1.0, 1.0, 1e6, 2e6, 1e5, 0.0); }, "Are the punches");
}

} // namespace
