#include "dem/surface/smooth_surface.hpp"
#include "dem/surface/stl.hpp"
#include "dem/surface/tool_shapes.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/solids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace dem {
namespace {

using support::ScratchFolder;

constexpr double mm = 1e-3;
constexpr double bore_radius = 11.025 * mm;

TriangleSurface seed_die() {
  return make_die(2.0 * bore_radius, 20.0 * mm, 10.0 * mm, 0.01 * mm);
}

/// Largest relative deviation of the Hertz force ~ overlap^1.5 on one grain from that of the smooth
/// cylinder, over angles and heights; `side` is -1 in a bore, +1 on a shaft. The force of all
/// contacts is summed, as a grain would.
double worst_force_error(SmoothSurface const& surface, double radius, double side, double grain,
                         double overlap) {
  double worst = 0.0;
  std::vector<SurfacePoint> found;
  for (int k = 0; k < 500; ++k) {
    double const angle = 0.0137 * k,
                 z = (3.0 + 0.027 * k) * mm; // 1.1 turns: every phase of a facet
    Vec3 const radial(std::cos(angle), std::sin(angle), 0.0);
    Vec3 const centre = (radius + side * (grain - overlap)) * radial + z * Vec3::UnitZ();
    found.clear();
    surface.find(centre, grain, found);
    Vec3 force = Vec3::Zero();
    for (auto const& contact : found)
      force += std::pow(grain - contact.distance, 1.5) * contact.normal;
    worst = std::max(worst, (force - std::pow(overlap, 1.5) * side * radial).norm() /
                                std::pow(overlap, 1.5));
  }
  return worst;
}

double worst_over_the_powder(SmoothSurface const& surface, double radius, double side) {
  double worst = 0.0;
  for (double const grain : {0.075 * mm, 0.125 * mm, 0.25 * mm, 0.5 * mm, 1.0 * mm, 1.5 * mm})
    for (double const relative : {0.02, 0.05, 0.2, 0.5})
      worst = std::max(worst, worst_force_error(surface, radius, side, grain, relative * grain));
  return worst;
}

TEST(FacetedBore, IsFollowedAsTheTrueCylinder) {
  // Recognised exactly: rounding of an 11 mm coordinate (2e-18 m) against the smallest overlap, 1.5
  // um.
  EXPECT_LT(worst_over_the_powder(SmoothSurface(seed_die()), bore_radius, -1.0), 1e-10);
}

TEST(FacetedBore, IsRecognisedFromSinglePrecision) {
  // A binary STL in millimetres holds 11.025 to 5e-7 mm; 0.5 nm of 1.5 um is 3.2e-4, times 1.5 in
  // force.
  ScratchFolder const folder;
  write_stl(folder / "die.stl", seed_die(), StlFormat::binary, mm);
  SmoothSurface const die(read_stl(folder / "die.stl", mm).surface);
  EXPECT_EQ(die.patches()[0].kind, PatchKind::cylinder);
  EXPECT_NEAR(die.patches()[0].radius, bore_radius, 5e-10);
  EXPECT_LT(worst_over_the_powder(die, bore_radius, -1.0), 1e-3);
}

TEST(FacetedBore, IsFollowedByItsNormalsAloneWithinOnePercent) {
  // The arc through the chord's ends and the true middle is a parabola: it errs by R phi^4/32 = 1.1
  // nm at a half angle phi = pi/74, which is 0.07 % of 1.5 um and 0.11 % in force; between arcs a
  // facet's inside adds to it.
  SmoothSurface const die(seed_die(), 0.35, Recognition::nothing);
  EXPECT_EQ(die.patches()[0].kind, PatchKind::curved);
  double const worst = worst_over_the_powder(die, bore_radius, -1.0);
  EXPECT_LT(worst, 0.01);
  EXPECT_GT(worst, 1e-5); // or the recognised cylinder was measured
  RecordProperty("worst_force_error", std::to_string(worst));
}

namespace {

/// The seed's die with the vertices of its bore off the circle by up to `most` [m].
TriangleSurface out_of_round(double most) {
  auto mesh = seed_die();
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> offset(-most, most);
  for (std::size_t k = 0; k < 2 * 74; ++k) {
    double const scale = 1.0 + offset(generator) / bore_radius;
    mesh.vertices[k].x() *= scale;
    mesh.vertices[k].y() *= scale;
  }
  return mesh;
}

} // namespace

TEST(FacetedBore, OutOfRoundIsFollowedByItsNormals) {
  // Vertices off the circle by up to 0.6 um (a sixteenth of the chord's depth) are no cylinder any
  // more. The distance then errs by about those 0.6 um, 40 % of the smallest overlap:
  // 1.4^1.5 - 1 = 66 %. For grains of 0.5 mm and up, with overlaps from 10 um, they give 9.1 %.
  SmoothSurface const die(out_of_round(6e-7));
  EXPECT_EQ(die.patches()[0].kind, PatchKind::curved);
  EXPECT_LT(worst_force_error(die, bore_radius, -1.0, 0.075 * mm, 1.5e-6), 0.7);
  EXPECT_LT(worst_force_error(die, bore_radius, -1.0, 0.5 * mm, 10e-6), 0.1);
}

TEST(FacetedBore, OfFiniteElementsIsRecognised) {
  // A second-order face over 15 degrees leaves the circle by 0.1 um.
  SmoothSurface const die(out_of_round(1e-7));
  EXPECT_EQ(die.patches()[0].kind, PatchKind::cylinder);
  EXPECT_LT(worst_force_error(die, bore_radius, -1.0, 0.075 * mm, 1.5e-6), 0.12);
  EXPECT_LT(worst_force_error(die, bore_radius, -1.0, 0.5 * mm, 10e-6), 0.02);
}

TEST(FacetedShaft, IsFollowedFromOutside) {
  auto const shaft = make_punch(2.0 * bore_radius, 20.0 * mm, 0.01 * mm, PunchFace::down);
  EXPECT_LT(worst_over_the_powder(SmoothSurface(shaft), bore_radius, 1.0), 1e-10);
  EXPECT_LT(
      worst_over_the_powder(SmoothSurface(shaft, 0.35, Recognition::nothing), bore_radius, 1.0),
      0.01);
}

TEST(FacetedCone, IsFollowedByItsNormals) {
  // A conical bore, 10 degrees from the axis: distance = (r_cone(z) - r) cos 10. Radii 10 to 13.5
  // mm.
  double const slope = std::tan(10.0 * pi / 180.0);
  std::vector<std::array<double, 2>> profile;
  for (int k = 10; k >= 0; --k)
    profile.push_back({(10.0 + 2.0 * k * slope) * mm, 2.0 * k * mm});
  SmoothSurface const cone(solids::revolve(profile, 74));
  ASSERT_EQ(cone.patches().size(), 1u);
  EXPECT_EQ(cone.patches()[0].kind, PatchKind::curved);
  double worst = 0.0;
  std::vector<SurfacePoint> found;
  for (int k = 0; k < 400; ++k) {
    double const angle = 0.0171 * k, z = (5.0 + 0.02 * k) * mm, wanted = 0.49 * mm;
    double const r = (10.0 * mm + z * slope) - wanted / std::cos(10.0 * pi / 180.0);
    found.clear();
    cone.find(Vec3(r * std::cos(angle), r * std::sin(angle), z), 0.5 * mm, found);
    ASSERT_EQ(found.size(), 1u);
    worst = std::max(worst, std::abs(found[0].distance - wanted));
  }
  EXPECT_LT(worst, 0.1e-6); // a hundredth of the 10 um and more by which the chords stand off
}

TEST(FacetedSphere, IsFollowedByItsNormals) {
  // 5 degrees a facet on R = 10 mm: chords stand off by R (1 - cos 2.5 deg) = 9.5 um a direction,
  // 19 um in all.
  std::vector<std::array<double, 2>> profile;
  for (int k = -12; k <= 12; ++k)
    profile.push_back(
        {10.0 * mm * std::cos(5.0 * k * pi / 180.0), 10.0 * mm * std::sin(5.0 * k * pi / 180.0)});
  SmoothSurface const ball(solids::revolve(profile, 72));
  double worst = 0.0;
  std::vector<SurfacePoint> found;
  for (int k = 0; k < 400; ++k) {
    double const angle = 0.0171 * k, tilt = -0.8 + 0.004 * k;
    Vec3 const normal(std::cos(tilt) * std::cos(angle), std::cos(tilt) * std::sin(angle),
                      std::sin(tilt));
    found.clear();
    ball.find(10.49 * mm * normal, 0.5 * mm, found);
    ASSERT_EQ(found.size(), 1u);
    worst = std::max(worst, std::abs(found[0].distance - 0.49 * mm));
  }
  EXPECT_LT(worst, 0.1e-6);
}

TEST(BoreRim, IsACircleAndJoinsBoreAndFaceWithoutAStep) {
  // A centre carried over the upper rim at a constant 0.3 mm from bore, rim and top face (a line, a
  // quarter circle, a line) keeps its distance at every angle around the axis; the rim's arcs err
  // by the 1.1 nm of a parabola.
  SmoothSurface const die(seed_die());
  std::vector<SurfacePoint> found;
  for (int k = 0; k <= 600; ++k)
    for (double const phase : {0.0, 0.013, 0.0425, 0.07}) {
      double const path = -0.4 * mm + k * (0.8 + 0.15 * pi) * mm / 600.0;
      double const turn = std::clamp(path / (0.3 * mm), 0.0, 0.5 * pi);
      double const r =
          bore_radius + std::max(path - 0.15 * pi * mm, 0.0) - 0.3 * mm * std::cos(turn);
      double const z = 20.0 * mm + std::min(path, 0.0) + 0.3 * mm * std::sin(turn);
      found.clear();
      die.find(Vec3(r * std::cos(phase), r * std::sin(phase), z), 0.35 * mm, found);
      ASSERT_EQ(found.size(), 1u) << path << ' ' << phase;
      EXPECT_NEAR(found[0].distance, 0.3 * mm, 2e-9) << path << ' ' << phase;
    }
}

TEST(BoreRim, DistanceToTheRimIsAlongTheBore) {
  SmoothSurface const die(seed_die());
  auto const point = die.on_patch(0, Vec3(10.0 * mm, 1.0 * mm, 13.0 * mm)).point;
  EXPECT_NEAR(std::hypot(point.x(), point.y()), bore_radius, 1e-17);
  EXPECT_NEAR(die.distance_to_rim(0, point), 7.0 * mm,
              1e-8); // to z = 20 mm, on an arc that errs by 1.1 nm
}

} // namespace
} // namespace dem
