// Bodies from closed STL files.
#include "continuum/tool/tet_subdivision.hpp"
#include "continuum/tool/triangle_distance.hpp"
#include "tests/support/near.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/continuum/refusal.hpp"
#include "tests/unit/continuum/tools.hpp"

#include <Eigen/Geometry>

#include <fstream>
#include <iomanip>
#include <numbers>
#include <sstream>

namespace {

using namespace continuum;
using std::numbers::pi;
using tools::a, tools::steel;

constexpr double b = 18e-3, height = 6e-3; // outer radius and height of the die [m]
Eigen::Vector3d const up = Eigen::Vector3d::UnitZ();

std::string stl_text(TraceTriangles const& skin, double scale, std::size_t n_left_out = 0) {
  std::ostringstream text;
  text << "solid tool\n" << std::setprecision(17);
  for (std::size_t t = n_left_out; t < skin.triangles.size(); ++t) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (std::uint32_t const v : skin.triangles[t])
      text << "vertex " << scale * skin.vertices[v].transpose() << "\n";
    text << "endloop\nendfacet\n";
  }
  text << "endsolid tool\n";
  return text.str();
}

std::filesystem::path save_die(support::ScratchFolder const& folder, double chord_tolerance,
                               double scale = 1.0, std::size_t n_left_out = 0) {
  ToolMesh const die = ToolMesh::die({.bore_radius = a, .outer_radius = b, .height = height},
                                     {.around = 32, .through_wall = 3, .along = 3});
  auto const file = folder.path() / "die.stl";
  support::put_bytes(file,
                     stl_text(die.boundary().triangulate(chord_tolerance), scale, n_left_out));
  return file;
}

StlOptions die_options(double cell_size) {
  return {.cell_size = cell_size,
          .gap_tolerance = 2e-4,
          .surfaces = {{"bore", CylinderShape{{0.0, 0.0, 0.0}, up, a}},
                       {"outer", CylinderShape{{0.0, 0.0, 0.0}, up, b}},
                       {"bottom", PlaneShape{{0.0, 0.0, 0.0}, up}},
                       {"top", PlaneShape{{0.0, 0.0, height}, 2.0 * up}}}};
}

std::size_t named(ToolMesh const& mesh, std::string const& name) {
  return std::ranges::count(mesh.surfaces(), name);
}

// The die that the facets stand for: areas of its cylinders, and Lame's displacement of the bore in
// plane strain. The gap left is the facets' own, not the cells'.
TEST(StlFile, GivesADieItsAreasAndDisplacement) {
  support::ScratchFolder const folder;
  auto const [mesh, gap] = ToolMesh::from_stl(save_die(folder, 1e-4), die_options(3.5e-3));
  for (char const* name : {"bore", "outer", "bottom", "top"})
    EXPECT_EQ(named(mesh, name), 1u);
  EXPECT_TRUE(near::relative(mesh.trace("bore").area(), 2.0 * pi * a * height, 1e-6));
  EXPECT_TRUE(near::relative(mesh.trace("outer").area(), 2.0 * pi * b * height, 1e-6));
  EXPECT_TRUE(near::relative(mesh.trace("top").area(), pi * (b * b - a * a), 1e-6));
  EXPECT_GT(gap, 1e-6);
  EXPECT_LE(gap, 1e-4); // the chord tolerance of the STL

  SurfaceTrace const outer = mesh.trace("outer");
  Supports supports{.surfaces = {{"bottom", {false, false, true}}, {"top", {false, false, true}}}};
  for (auto const& [x, component] :
       {std::pair{Eigen::Vector3d(b, 0, 0), 1}, {{-b, 0, 0}, 1}, {{0, b, 0}, 0}}) {
    Eigen::Index node = 0;
    (outer.positions.colwise() - x).colwise().norm().minCoeff(&node);
    supports.nodes.push_back({outer.nodes[node], {component == 0, component == 1, false}});
  }
  ElasticTool const tool(mesh, {steel}, supports);
  auto const u = tool.solve_pressure("bore", 65.7e6).displacement;
  SurfaceTrace const bore = mesh.trace("bore");
  double sum = 0.0;
  for (std::size_t i = 0; i < bore.nodes.size(); ++i)
    sum += tools::radial(bore.positions.col(i), u.col(bore.nodes[i]));
  double const exact = tools::Tube{a, b, 65.7e6, 0.0, steel}.displacement(a);
  EXPECT_TRUE(near::relative(sum / bore.nodes.size(), exact, 1e-4));
  RecordProperty("lame_um", std::to_string(exact * 1e6));
  RecordProperty("cells", std::to_string(mesh.n_cells()));
  RecordProperty("nodes", std::to_string(mesh.n_nodes()));
  RecordProperty("u_at_bore_um", std::to_string(sum / bore.nodes.size() * 1e6));
  RecordProperty("gap_um", std::to_string(gap * 1e6));
}

// Flat sides are met exactly, so their body is a patch test.
TEST(StlFile, MeetsFlatSidesExactly) {
  support::ScratchFolder const folder;
  auto const file = folder.path() / "block.STL";
  ToolMesh const block =
      ToolMesh::from_hexes(mesh_block({std::vector{0.0, 1.0, 3.0}, {0.0, 2.0}, {0.0, 1.0}},
                                      [](Eigen::Vector3d const& grid) { return grid; }));
  support::put_bytes(file, stl_text(block.boundary().triangulate(1e-3), 1e3));
  auto const [mesh, gap] =
      ToolMesh::from_stl(file, {.cell_size = 1.0,
                                .gap_tolerance = 1e-9,
                                .length_unit = 1e-3,
                                .surfaces = {{"bottom", PlaneShape{{0.0, 0.0, 0.0}, up}}},
                                .other_surface = "sides"});
  EXPECT_LT(gap, 1e-12);
  EXPECT_TRUE(near::relative(mesh.trace("bottom").area(), 6.0, 1e-12));
  EXPECT_TRUE(near::relative(mesh.trace("sides").area(), 16.0, 1e-12));
  ElasticTool const tool(mesh, {steel}, Supports::clamped("bottom"));
  Eigen::Matrix3Xd const linear = Eigen::Vector3d(3e-4, -2e-4, 5e-4) * mesh.nodes().row(2);
  auto const solution = tool.solve(tool.internal_forces(linear));
  EXPECT_LT((solution.displacement - linear).norm(), 1e-10 * linear.norm());
}

// A block's edges turn by 90 degrees: beyond that angle its sides are no patches of their own.
TEST(StlFile, PartsPatchesAtTheFeatureAngle) {
  support::ScratchFolder const folder;
  auto const file = folder.path() / "block.stl";
  ToolMesh const block =
      ToolMesh::from_hexes(mesh_block({std::vector{0.0, 1.0}, {0.0, 1.0}, {0.0, 1.0}},
                                      [](Eigen::Vector3d const& grid) { return grid; }));
  support::put_bytes(file, stl_text(block.boundary().triangulate(1e-3), 1.0));
  StlOptions options{.cell_size = 1.0, .gap_tolerance = 1e-9};
  for (int c = 0; c < 3; ++c)
    for (int const end : {0, 1})
      options.surfaces.push_back({std::string(end ? "high " : "low ") + "xyz" [c], PlaneShape {
                                    end *Eigen::Vector3d::Ones(), Eigen::Vector3d::Unit(c)
                                  }});
  EXPECT_EQ(ToolMesh::from_stl(file, options).mesh.surfaces().size(), 6u);
  options.feature_angle = 1.6; // 92 degrees
  expect_refusal([&] { ToolMesh::from_stl(file, options); }, "lies on no named shape");
}

TEST(StlFile, GetsFinerWithTheCellSize) {
  support::ScratchFolder const folder;
  auto const file = save_die(folder, 1e-4);
  auto options = die_options(6e-3);
  options.gap_tolerance = 1e-3;
  auto const coarse = ToolMesh::from_stl(file, options);
  options.cell_size = 4e-3;
  auto const fine = ToolMesh::from_stl(file, options);
  EXPECT_GT(fine.mesh.n_cells(), 1.5 * coarse.mesh.n_cells());
  EXPECT_LT(fine.largest_gap, coarse.largest_gap);
}

TEST(Refusal, OfStlFiles) {
  support::ScratchFolder const folder;
  auto const refuse = [&](std::filesystem::path const& file, StlOptions const& options,
                          std::string const& part) {
    expect_refusal([&] { ToolMesh::from_stl(file, options); }, file.string() + ": " + part);
  };
  auto good = die_options(6e-3);
  good.gap_tolerance = 1e-3;
  refuse(folder.path() / "none.stl", good, "cannot be read");
  support::put_bytes(folder.path() / "die.geo", "Error(\"run\");");
  refuse(folder.path() / "die.geo", good, "is no STL by its name (the ending is '.geo')");
  support::put_bytes(folder.path() / "die.stl", "solid die\nendsolid die\n");
  expect_refusal([&] { ToolMesh::from_stl(folder.path() / "die.stl", good); }, "die.stl: ");
  refuse(save_die(folder, 1e-4, 1.0, 1), good, "the edge at (");

  auto const file = save_die(folder, 1e-4);
  auto options = good;
  options.gap_tolerance = 1e-6;
  refuse(file, options, "the mesh leaves the STL by ");
  options = good;
  options.surfaces.erase(options.surfaces.begin());
  refuse(file, options, "the patch at (");
  options = good;
  options.surfaces[0].shape = CylinderShape{{0.0, 0.0, 0.0}, up, a + 2e-5};
  expect_refusal([&] { ToolMesh::from_stl(file, options); },
                 "; 'bore' is 2e-05 m off, with a shape tolerance of 1e-05 m");
  options.shape_tolerance = 3e-5;
  EXPECT_EQ(named(ToolMesh::from_stl(file, options).mesh, "bore"), 1u);
  options = good;
  options.feature_angle = 40.0;
  refuse(file, options, "feature angle = 40 rad");
  options = good;
  options.cell_size = 0.0;
  refuse(file, options, "cell size = 0 m");
  options = good;
  options.length_unit = -1.0;
  refuse(file, options, "length unit = -1 m");
}

TEST(TriangleDistance, FindsCornerSideAndMiddle) {
  std::array<Eigen::Vector3d, 3> const flat = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 0, 0),
                                               Eigen::Vector3d(0, 2, 0)};
  for (auto const& [x, closest] : {std::pair{Eigen::Vector3d(-1, -1, 1), Eigen::Vector3d(0, 0, 0)},
                                   {{3, -1, 0}, {2, 0, 0}},
                                   {{-1, 3, 0}, {0, 2, 0}},
                                   {{1, -2, 1}, {1, 0, 0}},
                                   {{-2, 1, 1}, {0, 1, 0}},
                                   {{2, 2, 5}, {1, 1, 0}},
                                   {{0.5, 0.5, -3}, {0.5, 0.5, 0}}})
    EXPECT_LT((closest_point(flat, x) - closest).norm(), 1e-15);
  // A lid lifted by 0.1 over a smaller one: 0.1 from below, the overhang sqrt(1 + 0.01) from above.
  Triangles const low{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}},
      high{{{0, 0, 0.1}, {2, 0, 0.1}, {0, 1, 0.1}}, {{0, 1, 2}}};
  EXPECT_NEAR(largest_gap(low, high), std::sqrt(1.01), 1e-15);
  EXPECT_NEAR(largest_gap(high, low), std::sqrt(1.01), 1e-15);
}

// However flat and whichever way round, a tetrahedron becomes four hexahedra of its volume.
TEST(TetSubdivision, NeverInverts) {
  for (double const h : {1.0, 1e-3, -1.0}) {
    TetSubdivision cut({{0, 0, 0}, {1, 0, 0}, {0.3, 2, 0}, {5, 5, h}});
    cut.add_tetrahedron({0, 1, 2, 3});
    for (auto const& corners : {std::array{0u, 1u, 2u}, {0u, 1u, 3u}, {1u, 2u, 3u}, {2u, 0u, 3u}})
      cut.add_triangle(corners, 0);
    ToolMesh const mesh = ToolMesh::from_hexes(cut.take({"skin"}));
    EXPECT_EQ(mesh.n_cells(), 4u);
    SurfaceTrace const skin = mesh.boundary();
    EXPECT_TRUE(near::relative(-skin.positions.cwiseProduct(skin.pressure_loads(1.0)).sum() / 3.0,
                               std::abs(h) / 3.0, 1e-12));
  }
}

} // namespace
