#include "coupling/study/packing_model.hpp"
#include "tests/unit/coupling/study_support.hpp"

#include <gtest/gtest.h>

namespace {

using namespace coupling::study;
using study_support::message_of;

constexpr double pressed = 9.0;

/// Coarse grains of size 1 and a share of fine ones.
double mixture(double fine_size, double fine_share, double beta) {
  return packed_fraction({{1.0, 1.0 - fine_share, beta}, {fine_size, fine_share, beta}}, pressed);
}

} // namespace

// The project's reference table of the model, worked out apart from this code: beta "0.7111", so
// that one size packs to 0.64. With beta = 0.7112 all 48 entries come out to their rounding. With
// 0.64 10/9 = 0.71111 two (0.6 at 0.40, 0.05 at 0.10) are 4e-5 beyond it.
TEST(PackingModel, GivesTheReferenceTable) {
  double const shares[] = {0.10, 0.20, 0.2258, 0.30, 0.40, 0.50};
  struct Row {
    double size, fractions[6];
  };
  for (auto const& [size, fractions] : {Row{0.6, {0.655, 0.668, 0.671, 0.677, 0.681, 0.678}},
                                        Row{0.4, {0.665, 0.688, 0.694, 0.706, 0.710, 0.703}},
                                        Row{0.3, {0.670, 0.701, 0.708, 0.724, 0.728, 0.718}},
                                        Row{0.2, {0.677, 0.716, 0.725, 0.746, 0.749, 0.734}},
                                        Row{0.1, {0.686, 0.736, 0.748, 0.774, 0.773, 0.752}},
                                        Row{0.05, {0.693, 0.750, 0.764, 0.793, 0.787, 0.762}},
                                        Row{0.02, {0.698, 0.763, 0.779, 0.808, 0.796, 0.768}},
                                        Row{0.001, {0.706, 0.780, 0.798, 0.822, 0.803, 0.773}}})
    for (int k = 0; k < 6; ++k) {
      EXPECT_NEAR(mixture(size, shares[k], 0.7112), fractions[k], 0.0005)
          << size << " " << shares[k];
      EXPECT_NEAR(mixture(size, shares[k], virtual_packing(0.64, pressed)), fractions[k], 0.00054);
    }
}

TEST(PackingModel, OfOneSizeHasItsClosedForm) {
  // Phi = beta K / (1 + K), however the size is cut into classes.
  for (double const K : {4.1, 9.0, 20.0}) {
    EXPECT_NEAR(packed_fraction({{2.0, 1.0, 0.7}}, K), 0.7 * K / (1.0 + K), 1e-14);
    EXPECT_NEAR(packed_fraction({{2.0, 0.3, 0.7}, {2.0, 0.5, 0.7}}, K), 0.7 * K / (1.0 + K), 1e-14);
  }
}

// An infinite ratio and a high index leave the virtual limits of Furnas: coarse dominant phi / (1 -
// y), fine dominant 1 / (y / phi + 1 - y), the best mixture 1 - (1 - phi)^2.
TEST(PackingModel, ReachesFurnasLimits) {
  auto const limit = [](double y) {
    return packed_fraction({{1.0, 1.0 - y, 0.64}, {1e-14, y, 0.64}}, 1e9);
  };
  EXPECT_NEAR(limit(0.1), 0.64 / 0.9, 1e-6);
  EXPECT_NEAR(limit(0.5), 1.0 / (0.5 / 0.64 + 0.5), 1e-6);
  EXPECT_NEAR(limit(0.36 / 1.36), 1.0 - 0.36 * 0.36, 1e-4);
}

TEST(PackingModel, RefusesWhatIsNoMixture) {
  EXPECT_EQ(message_of([] { packed_fraction({}, 9.0); }),
            "packing model: has no grains. Which sizes are mixed?");
  EXPECT_EQ(
      message_of([] {
        packed_fraction({{0.0, 1.0, 0.6}}, 9.0);
      }),
      "packing model: size = 0, share = 1, packing = 0.6 (sizes above 0, shares from 0, packing "
      "between 0 and 1). Is a value missing?");
  EXPECT_EQ(message_of([] {
              packed_fraction({{1.0, 0.0, 0.6}}, 9.0);
            }),
            "packing model: all shares are 0 (there is nothing to pack). Which are mixed?");
  EXPECT_EQ(message_of([] {
              packed_fraction({{1.0, 1.0, 0.6}}, 0.0);
            }),
            "packing model: compaction index = 0 (above 0; 9 for vibrated and pressed). Which is "
            "meant?");
}
