#include "coupling/reduced/bed_fit.hpp"
#include "dem/expect.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

using namespace coupling::reduced;

namespace {

Bed const bed{.solid_area = 7e-3, .bore = 22e-3};

/// A law like those of the full-size runs, unloading in two terms.
BedLaw truth() {
  BedLaw law{.stiffness = 400e6,
             .cohesion = 18e6,
             .onset = 0.63,
             .exponent = 1.6,
             .recovery = 0.95,
             .wall_friction = 0.19,
             .radial_ratio = 0.53,
             .opening = 1.0,
             .reversal = 1.5e-4};
  for (int k = 0; k <= 200; ++k) {
    double const g = k / 200.0;
    law.unloading.knots.push_back(g);
    law.unloading.values.push_back(k == 200 ? 1.0
                                            : 0.88 * std::pow(g, 2.5) + 0.12 * std::pow(g, 14.0));
  }
  return law;
}

/// Down to 8 mm, a dwell, and up, at `step` [m].
SimulatedCycle pressed(BedLaw const& law, double step, double up_to = 11.5e-3) {
  SimulatedCycle cycle;
  auto const record = [&](double height, double smallest) {
    auto const forces = bed_forces(law, bed, height, smallest);
    cycle.height.push_back(height);
    cycle.upper.push_back(forces.upper), cycle.lower.push_back(forces.lower);
    cycle.radial_pressure.push_back(forces.radial_pressure);
  };
  int const n_down = static_cast<int>(std::lround(4e-3 / step));
  for (int k = 0; k <= n_down; ++k)
    record(8e-3 + (n_down - k) * step, 8e-3 + (n_down - k) * step);
  for (int k = 0; k < 20; ++k)
    record(8e-3, 8e-3);
  for (int k = 1; 8e-3 + k * step < up_to; ++k)
    record(8e-3 + k * step, 8e-3);
  return cycle;
}

std::string message(std::function<void()> const& act) {
  try {
    act();
  } catch (dem::InvalidInput const& error) {
    return error.what();
  }
  return "accepted";
}

} // namespace

TEST(BedFit, FindsTheNumbersThatMadeTheCycle) {
  auto const fit = fit_bed_law(pressed(truth(), 0.03e-3), bed);
  EXPECT_NEAR(fit.law.stiffness, 400e6, 1e6);
  EXPECT_NEAR(fit.law.cohesion, 18e6, 0.3e6);
  EXPECT_NEAR(fit.law.onset, 0.63, 2e-4);
  EXPECT_NEAR(fit.law.exponent, 1.6, 2e-3);
  EXPECT_NEAR(fit.law.recovery, 0.95, 2e-3);
  EXPECT_NEAR(fit.law.wall_friction, 0.19, 1e-4);
  EXPECT_NEAR(fit.law.radial_ratio, 0.53, 1e-4);
  EXPECT_NEAR(fit.law.reversal, 1.5e-4, 2e-6);
  EXPECT_EQ(fit.law.opening, 1.0);
  EXPECT_LT(fit.loading_form, 1e-4);
  EXPECT_LT(fit.opening_form, 1e-4);
  EXPECT_TRUE(fit.statements.empty());
  for (auto const* departure :
       {&fit.loading_upper, &fit.loading_lower, &fit.unloading_upper, &fit.unloading_lower}) {
    EXPECT_LT(departure->rms, 5e-4);
    EXPECT_LT(departure->largest, 2e-3);
  }
}

/// What no formula says is in the tables: a bump in loading, a radial pressure and a turn of other
/// shapes, a coefficient of friction that changes.
TEST(BedFit, TablesHoldWhatFormulasMiss) {
  BedLaw odd = truth();
  odd.loading_rest = {{-0.05, 0.0, 0.1, 0.15, 0.3}, {0.0, 1e-4, 1.5e-3, 3e-3, -1e-3}};
  odd.radial_loading = {{0.0, 0.3}, {1.1, 0.95}};
  odd.radial_unloading = {{0.0, 0.4, 1.0}, {0.03, 0.5, 1.0}};
  odd.wall_loading = {{0.0, 0.3}, {0.8, 1.05}};
  odd.wall_turn = {{0.0, 1e-4, 4e-4, 1e-3, 3e-3}, {1.0, 0.2, -0.4, -0.85, -0.7}};
  auto const fit = fit_bed_law(pressed(odd, 0.03e-3), bed);
  EXPECT_GT(fit.loading_form, 1e-3);
  EXPECT_LT(fit.loading_upper.rms, 1e-3);
  EXPECT_LT(fit.loading_lower.rms, 1e-3);
  EXPECT_LT(fit.unloading_upper.rms, 1.5e-3);
  EXPECT_LT(fit.unloading_lower.rms, 1.5e-3);
  for (double const h : {8.0e-3, 8.2e-3, 9.0e-3}) {
    double const was = bed_forces(odd, bed, h, 8e-3).radial_pressure;
    EXPECT_NEAR(bed_forces(fit.law, bed, h, 8e-3).radial_pressure, was, 0.02 * was);
  }
}

TEST(BedFit, StandsNoiseAndFewRecords) {
  auto cycle = pressed(truth(), 0.02e-3);
  double const peak = bed_forces(truth(), bed, 8e-3, 8e-3).upper;
  for (std::size_t k = 0; k < cycle.height.size(); ++k) { // 0.3 % of the peak, of no pattern
    double const t = static_cast<double>(k);
    cycle.upper[k] += 3e-3 * peak * std::sin(12.9898 * t * t);
    cycle.lower[k] += 3e-3 * peak * std::sin(78.233 * t * t);
  }
  auto const noisy = fit_bed_law(cycle, bed);
  EXPECT_NEAR(noisy.law.loading(0.8), truth().loading(0.8), 2e-3 * truth().loading(0.875));
  EXPECT_LT(noisy.loading_upper.rms, 3e-3);
  EXPECT_LT(noisy.unloading_upper.rms, 3e-3);
  auto const few = fit_bed_law(pressed(truth(), 0.25e-3), bed); // 12 records of loading
  EXPECT_LT(few.loading_upper.rms, 1e-3);
  EXPECT_NEAR(few.law.loading(0.8), truth().loading(0.8), 1e-3 * truth().loading(0.875));
}

TEST(BedFit, SaysWhatIsMissing) {
  auto const none = fit_bed_law(pressed(truth(), 0.05e-3, 0.0), bed);
  EXPECT_TRUE(none.law.unloading.empty());
  EXPECT_EQ(none.n_unloading, 0u);
  ASSERT_EQ(none.statements.size(), 1u);
  EXPECT_EQ(none.statements[0], "the cycle has no unloading: its curves stay the standard ones");
  auto const little = fit_bed_law(pressed(truth(), 0.01e-3, 8.2e-3), bed);
  EXPECT_TRUE(little.law.wall_turn.empty());
  ASSERT_EQ(little.statements.size(), 1u);
  EXPECT_EQ(little.statements[0].substr(0, 40), "unloading is recorded 19 times, down to ");
}

TEST(BedFit, HoldsWhatItIsTold) {
  auto const fit =
      fit_bed_law(pressed(truth(), 0.05e-3), bed, {.onset = 0.625, .exponent = 1.7, .shape = {}});
  EXPECT_EQ(fit.law.onset, 0.625);
  EXPECT_EQ(fit.law.exponent, 1.7);
  EXPECT_LT(fit.loading_upper.rms, 1e-3); // the table makes up for it
}

/// A cause changes the numbers of a bed whose curves are known: the tables stay, the numbers
/// follow.
TEST(BedFit, FindsNumbersForAKnownShape) {
  BedLaw const base = fit_bed_law(pressed(truth(), 0.03e-3), bed).law;
  BedLaw changed = base;
  changed.stiffness *= 1.1, changed.cohesion *= 1.2, changed.onset += 0.004;
  changed.exponent += 0.03, changed.recovery -= 0.03, changed.opening = 1.1;
  changed.wall_friction = 0.22, changed.radial_ratio = 0.5;
  auto const fit =
      fit_bed_law(pressed(changed, 0.04e-3), bed, {.onset = {}, .exponent = {}, .shape = base});
  EXPECT_NEAR(fit.law.stiffness, changed.stiffness, 1e-3 * changed.stiffness);
  EXPECT_NEAR(fit.law.cohesion, changed.cohesion, 5e-3 * changed.cohesion);
  EXPECT_NEAR(fit.law.onset, changed.onset, 1e-4);
  EXPECT_NEAR(fit.law.exponent, changed.exponent, 1e-3);
  EXPECT_NEAR(fit.law.recovery, changed.recovery, 1e-3);
  EXPECT_NEAR(fit.law.opening, 1.1, 5e-3);
  EXPECT_NEAR(fit.law.wall_friction, 0.22, 1e-4);
  EXPECT_NEAR(fit.law.radial_ratio, 0.5, 1e-4);
  EXPECT_EQ(fit.law.unloading.values, base.unloading.values);
  EXPECT_EQ(fit.law.wall_turn.values, base.wall_turn.values);
  EXPECT_LT(fit.unloading_upper.rms, 1e-4);
}

TEST(BedFit, RefusesWhatIsNoCycle) {
  auto const good = pressed(truth(), 0.1e-3);
  auto const refused = [&](std::function<void(SimulatedCycle&)> const& spoil) {
    auto cycle = good;
    spoil(cycle);
    return message([&] { fit_bed_law(cycle, bed); });
  };
  EXPECT_EQ(refused([](auto& c) { c.lower.pop_back(); }).substr(0, 17), "simulated cycle: ");
  EXPECT_EQ(refused([](auto& c) { c.height[4] = -1e-3; }),
            "simulated cycle: record 5: height = -0.001 m: a bed is higher than nothing. Is it a "
            "travel instead?");
  EXPECT_EQ(refused([](auto& c) { c.upper[2] = NAN; }).substr(0, 33),
            "simulated cycle: record 3: forces");
  EXPECT_EQ(refused([](auto& c) {
              c.upper.assign(c.upper.size(), 0.0), c.lower.assign(c.lower.size(), 0.0);
            }),
            "simulated cycle: no force on the punches down to 0.008 m (the bed was never touched). "
            "Is the fill lower than the smallest gap?");
  EXPECT_EQ(refused([](auto& c) {
              c.upper.assign(c.upper.size(), 5.0), c.lower.assign(c.lower.size(), 5.0);
            }).substr(0, 41),
            "simulated cycle: the force does not rise ");
}
