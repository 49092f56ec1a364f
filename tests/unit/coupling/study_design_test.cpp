#include "coupling/study/design.hpp"
#include "dem/expect.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace coupling::study;
using Eigen::MatrixXd;

std::string message_of(auto const& act) {
  try {
    act();
  } catch (dem::InvalidInput const& error) {
    return error.what();
  }
  return "no error";
}

} // namespace

TEST(FullFactorial, RunsThroughTheLastFactorFirst) {
  MatrixXd expected(9, 2); // table 7 of the seed: modulus, cohesion
  expected << -1, -1, -1, 0, -1, 1, 0, -1, 0, 0, 0, 1, 1, -1, 1, 0, 1, 1;
  EXPECT_EQ(full_factorial({3, 3}), expected);
  MatrixXd mixed(8, 2);
  mixed << -1, -1, -1, -1.0 / 3.0, -1, 1.0 / 3.0, -1, 1, 1, -1, 1, -1.0 / 3.0, 1, 1.0 / 3.0, 1, 1;
  EXPECT_EQ(full_factorial({2, 4}), mixed);
}

TEST(CentralComposite, FaceCentredIsTheSeedsTable3) {
  MatrixXd const design = central_composite(3, AxialPoints::face_centred, 1);
  ASSERT_EQ(design.rows(), 15);
  // Table 3 in its own order: modulus, cohesion, diameter.
  MatrixXd seed(15, 3);
  seed << -1, -1, -1, -1, -1, 1, -1, 0, 0, -1, 1, -1, -1, 1, 1, 0, -1, 0, 0, 0, -1, 0, 0, 0, 0, 0,
      1, 0, 1, 0, 1, -1, -1, 1, -1, 1, 1, 0, 0, 1, 1, -1, 1, 1, 1;
  auto const rows = [](MatrixXd const& m) {
    std::vector<std::vector<double>> all;
    for (auto const& row : m.rowwise())
      all.emplace_back(row.begin(), row.end());
    std::ranges::sort(all);
    return all;
  };
  EXPECT_EQ(rows(design), rows(seed));
}

// Rotatable: the fourth moments hold [iiii] = 3 [iijj] (Myers et al., section 8.3.2).
TEST(CentralComposite, CircumscribedAndInscribedAreRotatable) {
  for (auto const kind : {AxialPoints::circumscribed, AxialPoints::inscribed})
    for (int k : {2, 3, 5}) {
      MatrixXd const d = central_composite(k, kind, 3);
      ASSERT_EQ(d.rows(), (1 << k) + 2 * k + 3);
      double const pure = d.col(0).array().pow(4).sum();
      double const mixed = (d.col(0).array() * d.col(1).array()).square().sum();
      EXPECT_NEAR(pure, 3.0 * mixed, 1e-12 * pure) << k;
      EXPECT_NEAR(d.cwiseAbs().maxCoeff(),
                  kind == AxialPoints::inscribed ? 1.0 : std::pow(2.0, k / 4.0), 1e-14);
    }
}

TEST(LatinHypercube, UsesEachCellOnceAndKeepsRunsApart) {
  MatrixXd const design = latin_hypercube(3, 12, 5);
  ASSERT_EQ(design.rows(), 12);
  for (int f = 0; f < 3; ++f) {
    std::vector<double> levels(design.col(f).begin(), design.col(f).end());
    std::ranges::sort(levels);
    for (int k = 0; k < 12; ++k)
      EXPECT_NEAR(levels[static_cast<std::size_t>(k)], -1.0 + (2 * k + 1) / 12.0, 1e-14);
  }
  EXPECT_EQ(design, latin_hypercube(3, 12, 5));
  EXPECT_NE(design, latin_hypercube(3, 12, 6));
  // One cell apart in each factor is the least possible, sqrt(3) / 6 = 0.29; a thousand draws reach
  // more than twice that.
  EXPECT_GT(closest_pair(design), 0.6);
}

// The numbers are those of this program; another platform must give them, too.
TEST(LatinHypercube, IsTheSameEverywhere) {
  MatrixXd const design = latin_hypercube(2, 5, 1);
  MatrixXd expected(5, 2);
  expected << 0, 0, 0.4, -0.8, -0.4, 0.8, 0.8, 0.4, -0.8, -0.4;
  EXPECT_LT((design - expected).cwiseAbs().maxCoeff(), 1e-12) << design;
}

TEST(Design, RefusesWhatCannotBeRun) {
  EXPECT_EQ(message_of([] { full_factorial({}); }),
            "full_factorial: has no factors (there is nothing to vary). Name at least one?");
  EXPECT_EQ(message_of([] {
              full_factorial({3, 1});
            }),
            "full_factorial: factor 2 has 1 level (a factor that does not vary has no effect). At "
            "least 2, or hold it?");
  EXPECT_EQ(message_of([] { full_factorial(std::vector<int>(60, 3)); }),
            "full_factorial: has more than 100000 runs (each is a simulation). Fewer factors or "
            "levels?");
  EXPECT_EQ(message_of([] { central_composite(1, AxialPoints::face_centred, 1); }),
            "central_composite: has 1 factor (its corners and axial points need two). Is "
            "full_factorial with three levels meant?");
  EXPECT_EQ(message_of([] { central_composite(2, AxialPoints::inscribed, -1); }),
            "central_composite: has -1 centre points. 0 or more?");
  EXPECT_EQ(message_of([] { latin_hypercube(0, 5, 1); }),
            "latin_hypercube: has no factors (there is nothing to vary). Name at least one?");
  EXPECT_EQ(message_of([] { latin_hypercube(2, 1, 1); }),
            "latin_hypercube: has 1 run (an effect needs two). More runs?");
}
