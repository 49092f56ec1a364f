#include "tests/diagnosis/hide/press.hpp"
#include "tests/diagnosis/hide/readings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace {

using namespace hidden;

bool same_bits(Cycle const& a, Cycle const& b) {
  for (std::size_t k = 0; k < a.moments.size(); ++k)
    if (a.moments[k].upper != b.moments[k].upper || a.moments[k].lower != b.moments[k].lower ||
        a.moments[k].radial != b.moments[k].radial || a.moments[k].height != b.moments[k].height)
      return false;
  return a.compact_height == b.compact_height && a.ejection_force == b.ejection_force;
}

/// Readings of one run, side by side: how far two cycles are apart in the noise of the sensors.
double distance(Cycle const& a, Cycle const& b) {
  double sum = std::pow((a.compact_height - b.compact_height) / height_sd, 2) +
               std::pow((a.ejection_force - b.ejection_force) / ejection_sd, 2);
  for (std::size_t k = 0; k < a.moments.size(); ++k) {
    auto const &x = a.moments[k], &y = b.moments[k];
    sum += std::pow((x.upper - y.upper) / force_sensor.at(x.upper), 2) +
           std::pow((x.lower - y.lower) / force_sensor.at(x.lower), 2) +
           std::pow((x.radial - y.radial) / pressure_sensor.at(x.radial), 2);
  }
  return std::sqrt(sum);
}

Cycle with(Effect effect, double size) {
  return press_cycle({}, Effects{}.with(effect, size), {}, {.mass_error = 1.0});
}

class HiddenEffects : public testing::TestWithParam<int> {
protected:
  static Cycle const& plain() {
    static Cycle const cycle = press_cycle({}, {}, {}, {.mass_error = 1.0});
    return cycle;
  }
  Effect effect() const { return static_cast<Effect>(GetParam()); }
};

TEST_P(HiddenEffects, OfNoSizeChangesNoBit) {
  EXPECT_TRUE(same_bits(with(effect(), 0.0), plain()));
  EXPECT_TRUE(same_bits(with(effect(), -0.0), plain()));
}

// The live switch: the generator cannot hide what does nothing.
TEST_P(HiddenEffects, OfPriorSizeStandsOutOfTheNoise) {
  EXPECT_GT(distance(with(effect(), kind_of(effect()).prior), plain()), 5.0);
}

// No two are one switch: a size of each differs from the other's in more than length.
TEST_P(HiddenEffects, GrowsWithItsSize) {
  double const prior = kind_of(effect()).prior;
  EXPECT_GT(distance(with(effect(), prior), plain()),
            1.2 * distance(with(effect(), 0.5 * prior), plain()));
}

INSTANTIATE_TEST_SUITE_P(All, HiddenEffects, testing::Range(0, n_effects), [](auto const& at) {
  return std::string(effect_kinds()[static_cast<std::size_t>(at.param)].name);
});

TEST(HiddenEffectNames, AreDistinctAndFound) {
  std::set<std::string_view> names;
  for (int k = 0; k < n_effects; ++k) {
    auto const name = effect_kinds()[static_cast<std::size_t>(k)].name;
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_EQ(effect_named(name), static_cast<Effect>(k));
  }
  EXPECT_THROW(effect_named("frame"), std::invalid_argument);
}

} // namespace
