#include "tests/support/near.hpp"
#include "tests/unit/continuum/tools.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <set>

namespace {

using namespace continuum;
using std::numbers::pi;
using tools::a;

double volume(TraceTriangles const& body) {
  double sum = 0.0;
  for (auto const& [i, j, k] : body.triangles)
    sum += body.vertices[i].dot(body.vertices[j].cross(body.vertices[k])) / 6.0;
  return sum;
}

// Every edge is run through once each way.
bool is_closed(TraceTriangles const& body) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> runs;
  for (auto const& t : body.triangles)
    for (int e = 0; e < 3; ++e)
      if (++runs[{t[e], t[(e + 1) % 3]}] > 1)
        return false;
  return std::ranges::all_of(runs, [&](auto const& run) {
    return runs.contains({run.first.second, run.first.first});
  });
}

// An arc of angle t as a parabola through three points of the circle: the radius errs by up to
// R t^4 / 512, the area of the disc by its t^4 / 480, 3.1e-6 for 32 cells around, and the arc's
// length by less.
TEST(ToolMesh, NamesSurfacesOfTheRightArea) {
  ToolMesh const die = ToolMesh::die(
      {.bore_radius = a, .outer_radius = 20e-3, .height = 12e-3, .ring_radius = 30e-3},
      {.around = 32, .through_wall = 2, .through_ring = 2, .along = 3});
  EXPECT_EQ(die.n_regions(), 2u);
  EXPECT_EQ(die.n_cells(), 32u * 4u * 3u);
  EXPECT_TRUE(near::relative(die.trace("bore").area(), 2.0 * pi * a * 12e-3, 3.2e-6));
  EXPECT_TRUE(near::relative(die.trace("outer").area(), 2.0 * pi * 30e-3 * 12e-3, 3.2e-6));
  for (char const* end : {"bottom", "top"})
    EXPECT_TRUE(near::relative(die.trace(end).area(), pi * (9e-4 - a * a), 3.2e-6));
  ToolMesh const punch = ToolMesh::punch({.radius = a, .length = 20e-3}, {.around = 32});
  for (char const* end : {"face", "back"})
    EXPECT_TRUE(near::relative(punch.trace(end).area(), pi * a * a, 3.2e-6));
  EXPECT_TRUE(near::relative(punch.trace("side").area(), 2.0 * pi * a * 20e-3, 3.2e-6));
}

TEST(ToolMesh, StandsWhereTheGrainsHaveIt) {
  ToolMesh const die = tools::small_die();
  EXPECT_TRUE((die.trace("bottom").positions.row(2).array() == 0.0).all());
  EXPECT_TRUE((die.trace("top").positions.row(2).array() == 12e-3).all());
  for (auto const& [place, inside] :
       {std::pair{PunchPlace::lower, -1.0}, {PunchPlace::upper, 1.0}}) {
    ToolMesh const punch = tools::small_punch(place);
    EXPECT_TRUE((punch.trace("face").positions.row(2).array() == 0.0).all());
    EXPECT_TRUE((punch.trace("back").positions.row(2).array() == inside * 50e-3).all());
    EXPECT_DOUBLE_EQ(punch.trace("face").normal(0, 0.3, 0.6).z(), -inside);
  }
}

// All nodes of a second-order face, not its corners alone, stand on the exact cylinder.
TEST(ToolMesh, PutsNodesOnTheExactCylinder) {
  for (SurfaceTrace const& trace :
       {tools::small_die().trace("bore"), tools::small_punch().trace("side")})
    EXPECT_LT((trace.positions.topRows(2).colwise().norm().array() - a).abs().maxCoeff(), 1e-15);
}

TEST(SurfaceTrace, PointsOutOfTheBody) {
  SurfaceTrace const bore = tools::small_die().trace("bore"),
                     side = tools::small_punch().trace("side");
  for (auto const& [trace, sign] : {std::pair{bore, -1.0}, {side, 1.0}})
    for (std::uint32_t face = 0; face < trace.faces.size(); ++face) {
      Eigen::Vector3d const x = trace.position(face, 0.2, 0.7);
      EXPECT_GT(sign * trace.normal(face, 0.2, 0.7).head<2>().dot(x.head<2>()) / x.head<2>().norm(),
                0.999);
    }
}

TEST(SurfaceTrace, ShapesSumToOneAndReproduceLinearFields) {
  SurfaceTrace const trace = tools::small_punch().trace("side");
  Eigen::RowVector3d const slope(2.0, -3.0, 0.7);
  Eigen::RowVectorXd const values = slope * trace.positions; // of a field linear in x
  for (auto const& [xi, eta] : {std::pair{0.1, 0.9}, {0.5, 0.25}, {1.0, 0.33}}) {
    auto const shape = face_shape(xi, eta);
    EXPECT_NEAR(shape.sum(), 1.0, 1e-15);
    EXPECT_LT(face_shape_gradient(xi, eta).colwise().sum().norm(), 1e-14);
    for (std::uint32_t face = 0; face < trace.faces.size(); ++face) {
      double value = 0.0;
      for (int n = 0; n < 9; ++n)
        value += shape[n] * values[trace.faces[face].nodes[n]];
      EXPECT_NEAR(value, slope.dot(trace.position(face, xi, eta)), 1e-15);
    }
  }
  Eigen::Matrix<double, 9, 1> const at_node_5 = face_shape(1.0, 0.5); // 3 j + i, i = 2, j = 1
  EXPECT_EQ(at_node_5[5], 1.0);
}

// On a closed surface a uniform pressure has no resultant.
TEST(SurfaceTrace, PressureOnAClosedSurfaceBalances) {
  SurfaceTrace const all = tools::small_punch().boundary();
  auto const loads = all.pressure_loads(1e6);
  EXPECT_LT(loads.rowwise().sum().norm(), 1e-12 * 1e6 * all.area());
  SurfaceTrace const face = tools::small_punch().trace("face");
  EXPECT_TRUE(near::relative(face.pressure_loads(1e6).row(2).sum(), -1e6 * face.area(), 1e-12));
}

TEST(TraceTriangles, AreClosedAndKeepTheTolerance) {
  for (ToolMesh const& mesh : {tools::small_die(), tools::small_punch()}) {
    SurfaceTrace const all = mesh.boundary();
    double previous = 0.0;
    for (double const tolerance : {1e-4, 1e-5, 1e-6}) {
      TraceTriangles const body = all.triangulate(tolerance);
      EXPECT_TRUE(is_closed(body));
      EXPECT_GT(volume(body), 0.0); // outward
      EXPECT_EQ(body.triangles.size(), all.faces.size() * 2 * body.per_edge * body.per_edge);
      EXPECT_EQ(body.faces.size(), body.triangles.size());
      EXPECT_GE(body.per_edge, previous);
      previous = body.per_edge;
    }
  }
}

TEST(TraceTriangles, StayOnTheBore) {
  SurfaceTrace const bore = tools::small_die().trace("bore");
  for (double const tolerance : {1e-4, 1e-5, 2e-6}) {
    TraceTriangles const surface = bore.triangulate(tolerance);
    for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
      auto const& place = surface.places[v];
      EXPECT_LT((surface.vertices[v] - bore.position(place.face, place.xi, place.eta)).norm(),
                1e-17);
      EXPECT_LT(std::abs(surface.vertices[v].head<2>().norm() - a), tolerance);
    }
    for (auto const& [i, j, k] : surface.triangles)
      for (auto const& [from, to] : {std::pair{i, j}, {j, k}, {k, i}}) {
        Eigen::Vector3d const chord = 0.5 * (surface.vertices[from] + surface.vertices[to]);
        // The parabola's own distance from the circle, R t^4 / 512 = 0.51 um here, comes on top.
        EXPECT_LT(std::abs(chord.head<2>().norm() - a), tolerance + 0.52e-6);
      }
  }
}

TEST(ToolMesh, HashTellsEveryParameter) {
  DieShape const shape{
      .bore_radius = 11e-3, .outer_radius = 20e-3, .height = 10e-3, .ring_radius = 30e-3};
  DieCells const cells{
      .around = 8, .through_wall = 2, .through_ring = 1, .along = 2, .growth = 2.0};
  std::vector<std::pair<DieShape, DieCells>> dies(9, {shape, cells});
  dies[1].first.bore_radius = 11.0001e-3;
  dies[2].first.outer_radius = 20.0001e-3;
  dies[3].first.height = 10.0001e-3;
  dies[4].first.ring_radius = 30.0001e-3;
  dies[5].second.around = 12;
  dies[6].second.through_wall = 3;
  dies[7].second.along = 3;
  dies[8].second.growth = 2.1;
  std::set<std::uint64_t> hashes;
  for (auto const& [changed, changed_cells] : dies)
    hashes.insert(ToolMesh::die(changed, changed_cells).hash());
  EXPECT_EQ(hashes.size(), dies.size());
  EXPECT_TRUE(hashes.contains(ToolMesh::die(shape, cells).hash())); // the same again
  EXPECT_NE(tools::small_punch(PunchPlace::lower).hash(),
            tools::small_punch(PunchPlace::upper).hash());
}

TEST(CellsOfSize, FollowTheSize) {
  DieCells const die =
      cells_of_size(DieShape{.bore_radius = a, .outer_radius = 30e-3, .height = 20e-3}, 2e-3);
  EXPECT_EQ(die.around, 36); // 2 pi a / size = 34.6, up to a multiple of 4
  EXPECT_EQ(die.along, 10);
  EXPECT_EQ(die.through_wall, 5); // 19 mm / (2 mm (1 + 3) / 2) = 4.7
  EXPECT_EQ(cells_of_size(PunchShape{.radius = a, .length = 20e-3}, 2e-3).around, 40);
}

} // namespace
