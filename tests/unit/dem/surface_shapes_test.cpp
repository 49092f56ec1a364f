#include "dem/expect.hpp"
#include "dem/surface/smooth_surface.hpp"
#include "dem/surface/surface_report.hpp"
#include "dem/surface/tool_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dem {
namespace {

constexpr double mm = 1e-3;

/// Area of the regular polygon with n corners on a circle: n/2 R^2 sin(2 pi/n).
double polygon_area(double n, double radius) {
  return 0.5 * n * radius * radius * std::sin(2.0 * pi / n);
}

TEST(ToolShapes, TheSeedsDieHas74Facets) {
  // pi / acos(1 - 0.01/11.025) = 73.75 -> 74
  EXPECT_EQ(n_facets(22.05 * mm, 0.01 * mm), 74u);
  // A tolerance that asks for fewer still gives facets that join smoothly; one lost in rounding
  // stays finite.
  EXPECT_EQ(n_facets(22.05 * mm, 5.0 * mm), 24u);
  EXPECT_EQ(n_facets(22.05 * mm, 1e-30), 100000u);
}

TEST(ToolShapes, TheChordsStayWithinTheTolerance) {
  for (double const tolerance : {0.1 * mm, 0.01 * mm, 0.001 * mm}) {
    double const n = n_facets(22.05 * mm, tolerance);
    EXPECT_LE(11.025 * mm * (1.0 - std::cos(pi / n)), tolerance);
    EXPECT_GT(11.025 * mm * (1.0 - std::cos(pi / (n - 1.0))), tolerance); // and no facet too many
  }
}

TEST(ToolShapes, DieIsAWatertightRing) {
  auto const die = make_die(22.05 * mm, 30.0 * mm, 10.0 * mm, 0.01 * mm);
  auto const report = inspect_surface(die);
  EXPECT_TRUE(report.closed);
  EXPECT_EQ(report.n_triangles, 8u * 74u);
  EXPECT_EQ(report.n_vertices, 4u * 74u);
  double const volume = (polygon_area(74, 21.025 * mm) - polygon_area(74, 11.025 * mm)) * 30.0 * mm;
  EXPECT_NEAR(report.volume / volume, 1.0, 1e-13);
  EXPECT_EQ(report.low.z(), 0.0);
  EXPECT_EQ(report.high.z(), 30.0 * mm);
}

TEST(ToolShapes, BoreIsRecognisedAndLooksAtItsAxis) {
  SmoothSurface const die(make_die(22.05 * mm, 30.0 * mm, 10.0 * mm, 0.01 * mm));
  ASSERT_EQ(die.patches().size(), 4u); // bore, top, shaft, bottom, in the order of their triangles
  auto const& bore = die.patches()[0];
  EXPECT_EQ(bore.kind, PatchKind::cylinder);
  EXPECT_NEAR(bore.radius, 11.025 * mm, 1e-16);
  EXPECT_EQ(bore.side, -1.0);
  EXPECT_LT((bore.direction - Vec3::UnitZ()).norm(), 1e-14);
  EXPECT_LT(std::hypot(bore.origin.x(), bore.origin.y()), 1e-16);
  EXPECT_EQ(die.patches()[1].kind, PatchKind::plane);
  EXPECT_NEAR(die.patches()[1].direction.z(), 1.0, 1e-15);
  EXPECT_EQ(die.patches()[2].side, 1.0);
  EXPECT_NEAR(die.patches()[3].direction.z(), -1.0, 1e-15);
}

TEST(ToolShapes, PunchFacesAreAtZeroOfTheirOwnFrame) {
  auto const lower = make_punch(22.0 * mm, 20.0 * mm, 0.01 * mm, PunchFace::up);
  auto const upper = make_punch(22.0 * mm, 20.0 * mm, 0.01 * mm, PunchFace::down);
  EXPECT_EQ(lower.name, "lower_punch");
  EXPECT_EQ(upper.name, "upper_punch");
  for (auto const* punch : {&lower, &upper}) {
    auto const report = inspect_surface(*punch);
    EXPECT_TRUE(report.closed);
    EXPECT_NEAR(report.volume / (polygon_area(74, 11.0 * mm) * 20.0 * mm), 1.0, 1e-13);
  }
  EXPECT_EQ(inspect_surface(lower).high.z(), 0.0);
  EXPECT_EQ(inspect_surface(lower).low.z(), -20.0 * mm);
  EXPECT_EQ(inspect_surface(upper).low.z(), 0.0);
  std::vector<SurfacePoint> found;
  SmoothSurface(lower).find(Vec3(1.0 * mm, 0.0, 0.4 * mm), 0.5 * mm, found);
  SmoothSurface(upper).find(Vec3(1.0 * mm, 0.0, -0.4 * mm), 0.5 * mm, found);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].distance, 0.4 * mm);
  EXPECT_EQ(found[0].normal, Vec3::UnitZ());
  EXPECT_EQ(found[1].distance, 0.4 * mm);
  EXPECT_EQ(found[1].normal, Vec3(-Vec3::UnitZ()));
}

TEST(ToolShapes, RefuseWhatIsNoLength) {
  double const nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(make_die(-1.0, 1.0, 1.0, 0.1), InvalidInput);
  EXPECT_THROW(make_die(1.0, nan, 1.0, 0.1), InvalidInput);
  EXPECT_THROW(make_die(1.0, 1.0, 0.0, 0.1), InvalidInput);
  EXPECT_THROW(make_punch(1.0, 1.0, 0.0, PunchFace::up), InvalidInput);
}

} // namespace
} // namespace dem
