// Bevelled and concave punches against the closed forms of cone and sphere.
#include "tests/support/near.hpp"
#include "tests/unit/continuum/tools.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <numbers>

namespace {

using namespace continuum;
using std::numbers::pi;
using tools::a, tools::steel;

constexpr double length = 20e-3;
constexpr BevelledFace bevel{.width = 2e-3, .depth = 1e-3};
constexpr ConcaveFace cup{.depth = 3e-3, .land = 1e-3};

ToolMesh punch_with(decltype(PunchShape::face) const& face, int refinement = 2,
                    PunchPlace place = PunchPlace::lower) {
  return ToolMesh::punch(
      {.radius = a, .length = length, .place = place, .face = face},
      {.around = 8 * refinement, .rings = refinement, .along = 3, .rim = refinement});
}

// A pressure p on a closed surface does the work -3 p V on the field u = x.
double volume(ToolMesh const& mesh) {
  SurfaceTrace const all = mesh.boundary();
  return -all.positions.cwiseProduct(all.pressure_loads(1.0)).sum() / 3.0;
}

struct ClosedForm {
  decltype(PunchShape::face) face;
  double area, volume;
};

// Cone frustum: area pi (R + c) s, s the slant; the ring between it and z = 0 has the volume
// 2 pi (d / w) [ (R^3 - c^3) / 3 - c (R^2 - c^2) / 2 ],  c = R - w.
ClosedForm bevelled(BevelledFace const& face) {
  double const c = a - face.width, slant = std::hypot(face.width, face.depth);
  double const ring = 2.0 * pi * face.depth / face.width *
                      ((a * a * a - c * c * c) / 3.0 - c * (a * a - c * c) / 2.0);
  return {face, pi * c * c + pi * (a + c) * slant, pi * a * a * length - ring};
}

// Spherical cap: area pi (c^2 + d^2), volume pi d (3 c^2 + d^2) / 6,  c = R - land.
ClosedForm concave(ConcaveFace const& face) {
  double const c = a - face.land, d = face.depth;
  return {face, pi * (c * c + d * d) + pi * (a * a - c * c),
          pi * a * a * length - pi * d * (3.0 * c * c + d * d) / 6.0};
}

// Faces are parabolas through nodes of the exact surface: areas and volumes err with order four.
TEST(PunchShapes, HaveTheAreaAndVolumeOfTheirClosedForms) {
  for (ClosedForm const& exact :
       {bevelled(bevel), bevelled({.width = 2e-3, .depth = -1e-3}), concave(cup),
        concave({.depth = 3e-3}), concave({.depth = 4e-3, .land = 2e-3})}) {
    std::array<double, 2> of_area, of_volume;
    for (int const level : {0, 1}) {
      ToolMesh const mesh = punch_with(exact.face, 4 << level);
      of_area[level] = std::abs(mesh.trace("face").area() / exact.area - 1.0);
      of_volume[level] = std::abs(volume(mesh) / exact.volume - 1.0);
    }
    std::string const name = "shape_" + std::to_string(exact.face.index()) + "_" +
                             std::to_string(std::lround(1e9 * exact.volume));
    RecordProperty("error_of_area_" + name, std::to_string(1e6 * of_area[1]) + "e-6");
    RecordProperty("order_of_area_" + name, std::to_string(std::log2(of_area[0] / of_area[1])));
    RecordProperty("error_of_volume_" + name, std::to_string(1e6 * of_volume[1]) + "e-6");
    RecordProperty("order_of_volume_" + name,
                   std::to_string(std::log2(of_volume[0] / of_volume[1])));
    EXPECT_GE(std::log2(of_area[0] / of_area[1]), 3.8) << name;
    EXPECT_GE(std::log2(of_volume[0] / of_volume[1]), 3.8) << name;
    EXPECT_LT(of_area[1], 4e-7) << name;
    EXPECT_LT(of_volume[1], 4e-7) << name;
  }
}

// Every node of the face, mid-side and middle ones too, on cone, land or sphere to rounding.
TEST(PunchShapes, PutNodesOnTheExactConeAndSphere) {
  for (PunchPlace const place : {PunchPlace::lower, PunchPlace::upper}) {
    double const into_body = place == PunchPlace::lower ? -1.0 : 1.0;
    int n_on_cone = 0;
    SurfaceTrace const cone = punch_with(bevel, 2, place).trace("face");
    for (auto const& x : cone.positions.colwise()) {
      double const r = x.head<2>().norm(), out = std::max(0.0, r - (a - bevel.width));
      EXPECT_NEAR(into_body * x.z(), bevel.depth * out / bevel.width, 1e-17);
      n_on_cone += out > 1e-9;
    }
    EXPECT_EQ(n_on_cone, 4 * 32); // two rings of 16 cells, four half cells wide

    double const sphere = cup.sphere_radius(a);
    Eigen::Vector3d const middle(0.0, 0.0, -into_body * (sphere - cup.depth));
    int n_on_sphere = 0;
    SurfaceTrace const hollow = punch_with(cup, 2, place).trace("face");
    for (auto const& x : hollow.positions.colwise()) {
      bool const is_land = x.head<2>().norm() > a - cup.land - 1e-12;
      EXPECT_NEAR(is_land ? x.z() : (x - middle).norm() - sphere, 0.0, 5e-18);
      n_on_sphere += !is_land;
    }
    EXPECT_GT(n_on_sphere, 50);
  }
  // (c^2 + d^2) / (2 d) with c = 10.025 mm, d = 3 mm
  EXPECT_TRUE(near::relative(cup.sphere_radius(a), 18.250104e-3, 1e-6));
}

TEST(PunchShapes, KeepSideAndBack) {
  for (auto const& face : {decltype(PunchShape::face)(bevel), decltype(PunchShape::face)(cup)}) {
    ToolMesh const mesh = punch_with(face, 4);
    EXPECT_TRUE((mesh.trace("back").positions.row(2).array() == -length).all());
    EXPECT_TRUE(near::relative(mesh.trace("back").area(), pi * a * a, 1e-5));
    double const lost = std::holds_alternative<BevelledFace>(face) ? bevel.depth : 0.0;
    EXPECT_TRUE(near::relative(mesh.trace("side").area(), 2.0 * pi * a * (length - lost), 1e-5));
    SurfaceTrace const trace = mesh.trace("face");
    for (std::uint32_t f = 0; f < trace.faces.size(); ++f)
      EXPECT_GT(trace.normal(f, 0.4, 0.6).z(), 0.5); // towards the powder
  }
}

// As in PatchTest, on cells that cone and sphere distort.
TEST(PunchShapes, PassThePatchTest) {
  for (auto const& face : {decltype(PunchShape::face)(bevel), decltype(PunchShape::face)(cup)}) {
    ElasticTool const tool(punch_with(face), {steel}, Supports::clamped("back"));
    Eigen::Vector3d const c(3e-4, -2e-4, 5e-4);
    Eigen::Matrix3Xd const linear =
        c * (tool.mesh().nodes().row(2).array() + length).matrix(); // zero on the back
    auto const solution = tool.solve(tool.internal_forces(linear));
    EXPECT_LT((solution.displacement - linear).norm(), 1e-10 * linear.norm());
    // The same traction as surface loads: sigma n with sigma of a linear field, on all of it.
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
    gradient.col(2) = c;
    Eigen::Matrix3d const stress = steel.stress(0.5 * (gradient + gradient.transpose()));
    SurfaceTrace const all = tool.mesh().boundary();
    auto const loads = tool.spread(
        all, all.traction_loads([&](Eigen::Vector3d const&, Eigen::Vector3d const& normal) {
          return Eigen::Vector3d(stress * normal);
        }));
    EXPECT_LT((tool.solve(loads).displacement - linear).norm(), 1e-10 * linear.norm());
  }
}

TEST(PunchShapes, AreTellableByTheirHash) {
  std::vector<decltype(PunchShape::face)> const faces = {
      FlatFace{},
      bevel,
      BevelledFace{.width = 2.1e-3, .depth = 1e-3},
      BevelledFace{.width = 2e-3, .depth = 1.1e-3},
      cup,
      ConcaveFace{.depth = 3.1e-3, .land = 1e-3},
      ConcaveFace{.depth = 3e-3, .land = 1.1e-3}};
  std::vector<std::uint64_t> hashes;
  for (auto const& face : faces)
    hashes.push_back(punch_with(face).hash());
  hashes.push_back(ToolMesh::punch({.radius = a, .length = length, .face = cup},
                                   {.around = 16, .rings = 2, .along = 3, .rim = 3})
                       .hash());
  std::ranges::sort(hashes);
  EXPECT_EQ(std::ranges::adjacent_find(hashes), hashes.end());
}

TEST(PunchShapes, TakeCellsOfASize) {
  EXPECT_EQ(cells_of_size(PunchShape{.radius = a, .length = length, .face = bevel}, 0.5e-3).rim, 4);
  EXPECT_EQ(cells_of_size(PunchShape{.radius = a, .length = length, .face = cup}, 0.5e-3).rim, 2);
  // 0.4 (11.025 - 2) mm / 0.5 mm = 7.2
  EXPECT_EQ(cells_of_size(PunchShape{.radius = a, .length = length, .face = bevel}, 0.5e-3).rings,
            8);
}

} // namespace
