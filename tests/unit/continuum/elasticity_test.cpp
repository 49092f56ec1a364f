// The problems of continuum/verification, each row within its tolerance.
#include "continuum/verification/problems.hpp"

#include <gtest/gtest.h>

namespace {

using namespace continuum::verification;

void expect_passed(Checks const& checks, std::size_t n) {
  EXPECT_EQ(checks.size(), n);
  for (Check const& check : checks) {
    EXPECT_TRUE(check.passes()) << check.name << ": " << check.result << " against "
                                << check.reference << ", error " << check.error() << " > "
                                << check.tolerance;
    ::testing::Test::RecordProperty(check.name, testing::PrintToString(check.result) + " against " +
                                                    testing::PrintToString(check.reference));
  }
}

TEST(Elasticity, TubeInPlaneStrain) {
  expect_passed(check_tube_in_plane_strain(), 4);
}
TEST(Elasticity, TubeWithFreeEnds) {
  expect_passed(check_tube_with_free_ends(), 1);
}
TEST(Elasticity, ThickEllipticPlateOfNafems) {
  expect_passed(check_thick_elliptic_plate(), 1);
}
TEST(Elasticity, ManufacturedSolution) {
  expect_passed(check_manufactured_solution(), 4);
}
TEST(Elasticity, Beams) {
  expect_passed(check_beams(), 2);
}
TEST(Elasticity, Discs) {
  expect_passed(check_discs(), 2);
}
TEST(Elasticity, HertzPressure) {
  expect_passed(check_hertz_pressure(), 4);
}
TEST(Elasticity, Column) {
  expect_passed(check_column(), 2);
}

TEST(Check, FailsOutsideItsToleranceAndForNan) {
  EXPECT_TRUE((Check{"x", -2.0, -2.01, 0.0051, ""}.passes()));
  EXPECT_FALSE((Check{"x", -2.0, -2.01, 0.0049, ""}.passes()));
  EXPECT_FALSE((Check{"x", -2.0, -1.99, 0.0049, ""}.passes()));
  EXPECT_FALSE((Check{"x", 0.0, 2e-3, 1e-3, ""}.passes()));
  EXPECT_FALSE((Check{"x", 1.0, std::nan(""), 1.0, ""}.passes()));
}

} // namespace
