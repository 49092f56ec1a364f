#include "dem/surface/smooth_surface.hpp"
#include "tests/support/oracles/brute_force_surface.hpp"
#include "tests/support/solids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace dem {
namespace {

std::vector<SurfacePoint> find(SmoothSurface const& surface, Vec3 const& centre, double reach) {
  std::vector<SurfacePoint> found;
  surface.find(centre, reach, found);
  return found;
}

std::vector<std::uint32_t> patch_of_triangles(SmoothSurface const& surface) {
  std::vector<std::uint32_t> patch_of;
  auto const& mesh = surface.triangles();
  for (auto const& corners : mesh.triangles) {
    Vec3 const middle =
        (mesh.vertices[corners[0]] + mesh.vertices[corners[1]] + mesh.vertices[corners[2]]) / 3.0;
    for (std::uint32_t patch = 0; patch < surface.patches().size(); ++patch) {
      auto const& plane = surface.patches()[patch];
      Vec3 const normal = (mesh.vertices[corners[1]] - mesh.vertices[corners[0]])
                              .cross(mesh.vertices[corners[2]] - mesh.vertices[corners[0]])
                              .normalized();
      if (std::abs((middle - plane.origin).dot(plane.direction)) < 1e-12 &&
          normal.dot(plane.direction) > 0.999)
        patch_of.push_back(patch);
    }
  }
  return patch_of;
}

/// Equal contacts: the same number, and each one's distance, and its way from the point to the
/// centre.
void expect_equal(std::vector<SurfacePoint> const& fast, std::vector<oracle::Contact> slow,
                  Vec3 const& centre) {
  ASSERT_EQ(fast.size(), slow.size()) << "at " << centre.transpose();
  for (std::size_t k = 0; k < fast.size(); ++k) {
    EXPECT_NEAR(fast[k].distance, slow[k].distance, 1e-14) << "at " << centre.transpose();
    EXPECT_LT((fast[k].point - slow[k].point).norm(), 1e-13) << "at " << centre.transpose();
    EXPECT_NEAR(fast[k].normal.norm(), 1.0, 1e-14);
    EXPECT_LT((fast[k].point + fast[k].distance * fast[k].normal - centre).norm(), 1e-13);
  }
}

class AgainstBruteForce : public testing::TestWithParam<int> {
protected:
  AgainstBruteForce()
      : surface(GetParam() == 0 ? solids::block(2.0, 1.5, 0.5) : solids::angle_iron(2.0)),
        slow(surface.triangles(), patch_of_triangles(surface)) {}

  SmoothSurface surface;
  oracle::BruteForceSurface slow;
  std::mt19937 generator{20240611};
};

TEST_P(AgainstBruteForce, RandomCentresInsideAndOutside) {
  std::uniform_real_distribution<double> coordinate(-1.0, 4.0);
  for (int k = 0; k < 20000; ++k) {
    Vec3 const centre(coordinate(generator), coordinate(generator), coordinate(generator));
    expect_equal(find(surface, centre, 0.7), slow.find(centre, 0.7), centre);
  }
}

TEST_P(AgainstBruteForce, CentresNearFacesEdgesAndVertices) {
  std::uniform_real_distribution<double> weight(0.0, 1.0);
  std::normal_distribution<double> normal;
  auto const& mesh = surface.triangles();
  for (int k = 0; k < 20000; ++k) {
    auto const& corners = mesh.triangles[static_cast<std::size_t>(k) % mesh.triangles.size()];
    double const u = weight(generator), v = (k / 7) % 3 == 0 ? weight(generator) * (1.0 - u) : 0.0;
    Vec3 const at = (k / 7) % 3 == 2
                        ? mesh.vertices[corners[0]]
                        : Vec3(mesh.vertices[corners[0]] * (1.0 - u - v) +
                               u * mesh.vertices[corners[1]] + v * mesh.vertices[corners[2]]);
    double const offset = std::pow(10.0, -6.0 * weight(generator));
    Vec3 const centre =
        at +
        0.4 * offset * Vec3(normal(generator), normal(generator), normal(generator)).normalized();
    expect_equal(find(surface, centre, 0.5), slow.find(centre, 0.5), centre);
  }
}

INSTANTIATE_TEST_SUITE_P(Polyhedra, AgainstBruteForce, testing::Values(0, 1));

TEST(EdgeCounting, ACentreOverAnEdgeHasOneContactWhateverTheRounding) {
  // Straight above a convex edge the face, its rim and the neighbour's rim are all equally near.
  // Offsets of 1e-12 and less to either side must neither lose the contact nor count it twice.
  SmoothSurface const block(solids::block(2.0, 1.5, 0.5));
  for (double const across : {0.0, 1e-18, 1e-16, 1e-14, 1e-12, 1e-10, 1e-8})
    for (double const sign : {-1.0, 1.0})
      for (double const height : {1e-3, 0.1, 0.4}) {
        auto const over_edge = find(block, Vec3(2.0 + sign * across, 0.7, height), 0.45);
        ASSERT_EQ(over_edge.size(), 1u) << across << ' ' << height;
        EXPECT_NEAR(over_edge[0].distance, height, 1e-12);
        auto const over_corner =
            find(block, Vec3(2.0 + sign * across, 1.5 - sign * across, height), 0.45);
        ASSERT_EQ(over_corner.size(), 1u) << across << ' ' << height;
        EXPECT_NEAR(over_corner[0].distance, height, 1e-12);
      }
}

TEST(EdgeCounting, AGrainThatRollsOverARightAngleFeelsOneContinuousDistance) {
  // A centre carried along the offset curve of the block (a line, a quarter circle, a line) at 0.3
  // keeps its distance and has exactly one contact; its normal turns with the path.
  SmoothSurface const block(solids::block(2.0, 1.5, 0.5));
  for (int k = 0; k <= 4000; ++k) {
    double const path = -0.4 + k * (0.8 + 0.15 * pi) / 4000.0;
    double const angle = std::clamp(path / 0.3, 0.0, 0.5 * pi);
    Vec3 const normal(std::sin(angle), 0.0, std::cos(angle));
    Vec3 const foot(2.0 + std::min(path, 0.0), 0.7, -std::max(path - 0.15 * pi, 0.0));
    auto const found = find(block, foot + 0.3 * normal, 0.35);
    ASSERT_EQ(found.size(), 1u) << "at " << path;
    EXPECT_NEAR(found[0].distance, 0.3, 1e-14);
    EXPECT_LT((found[0].normal - normal).norm(), 1e-13);
  }
}

TEST(EdgeCounting, AConcaveCornerGivesTwoContacts) {
  SmoothSurface const iron(solids::angle_iron(2.0));
  auto const found =
      find(iron, Vec3(1.9, 1.0, 1.2), 0.3); // 0.1 from the wall x = 2, 0.2 above the floor z = 1
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(std::min(found[0].distance, found[1].distance), 0.1, 1e-15);
  EXPECT_NEAR(std::max(found[0].distance, found[1].distance), 0.2, 1e-15);
}

TEST(ThinTool, AGrainIsNotSeizedThroughTheBody) {
  // A plate 0.05 thick and a grain of radius 0.3 whose centre stands 0.1 above it: the lower face,
  // 0.15 below the centre and well within reach, must not pull it through. Pressed 0.01 into the
  // plate it is still pushed up.
  SmoothSurface const plate(solids::block(2.0, 2.0, 0.05));
  for (double const height : {0.1, 0.01, 1e-9, -1e-9, -0.01, -0.02}) {
    auto const found = find(plate, Vec3(1.0, 1.0, height), 0.3);
    ASSERT_EQ(found.size(), 1u) << height;
    EXPECT_NEAR(found[0].distance, height, 1e-15);
    EXPECT_NEAR(found[0].normal.z(), 1.0, 1e-15);
  }
  // Past the middle plane the other face is the way out.
  auto const below = find(plate, Vec3(1.0, 1.0, -0.03), 0.3);
  ASSERT_EQ(below.size(), 1u);
  EXPECT_NEAR(below[0].normal.z(), -1.0, 1e-15);
  EXPECT_NEAR(below[0].distance, -0.02, 1e-15);
}

TEST(ThinTool, DepthBehindAFaceIsLimitedToTheReach) {
  SmoothSurface const wall(solids::block(10.0, 10.0, 10.0));
  EXPECT_EQ(find(wall, Vec3(5.0, 5.0, -0.29), 0.3).size(), 1u);
  EXPECT_EQ(find(wall, Vec3(5.0, 5.0, -0.31), 0.3).size(), 0u);
}

TEST(FlatFace, DoesNotDependOnItsTriangulation) {
  // Inside the rim and around it, the contact with a unit square is the same to rounding for 2, 50
  // and 5000 triangles with random inner vertices.
  SmoothSurface const coarse(solids::random_square(2, 1));
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> across(-0.1, 1.1), height(-0.09, 0.1);
  for (auto const& [n, seed] : {std::pair{50u, 3u}, std::pair{5000u, 4u}}) {
    SmoothSurface const fine(solids::random_square(n, seed));
    ASSERT_GE(fine.triangles().triangles.size(), n);
    ASSERT_EQ(fine.patches().size(), 1u);
    EXPECT_EQ(fine.patches()[0].kind, PatchKind::plane);
    for (int k = 0; k < 5000; ++k) {
      Vec3 const centre(across(generator), across(generator), height(generator));
      auto const one = find(coarse, centre, 0.1), other = find(fine, centre, 0.1);
      ASSERT_EQ(one.size(), other.size());
      for (std::size_t c = 0; c < one.size(); ++c) {
        EXPECT_NEAR(one[c].distance, other[c].distance, 1e-15);
        EXPECT_LT((one[c].point - other[c].point).norm(), 1e-15);
        EXPECT_LT((one[c].normal - other[c].normal).norm(), 1e-13);
      }
    }
  }
}

TEST(FlatFace, OnPatchIsWhatFindGivesAndNeedsTheRim) {
  SmoothSurface const square(solids::random_square(500, 9));
  Vec3 const centre(0.3, 0.8, 0.05);
  auto const found = find(square, centre, 0.1);
  ASSERT_EQ(found.size(), 1u);
  auto const quick = square.on_patch(0, centre);
  EXPECT_EQ(quick.distance, found[0].distance);
  EXPECT_EQ(quick.normal, found[0].normal);
  EXPECT_EQ(quick.point, found[0].point);
  // (0.3, 0.8) is 0.2 from the side y = 1, and the triangle at it is the one that find named.
  EXPECT_NEAR(square.distance_to_rim(0, quick.point), 0.2, 1e-15);
  EXPECT_EQ(square.triangle_at(0, quick.point), found[0].triangle);
}

} // namespace
} // namespace dem
