// Files of gmsh, written by gmsh.
#include "tests/support/near.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/continuum/refusal.hpp"
#include "tests/unit/continuum/tools.hpp"

#include <gmsh.h>

#include <numbers>

namespace {

using namespace continuum;
using std::numbers::pi;
using tools::a, tools::b, tools::steel;
namespace geo = gmsh::model::geo;

struct Saved {
  double version = 4.1;
  int binary = 0;
  int order = 2;
  int incomplete = 0; // serendipity elements
  bool has_groups = true;
  bool is_recombined = true; // hexahedra, not prisms
  double scale = 1e3;        // of lengths in the file: mm
};

// A quarter of a tube, 8 x 3 x 1 cells, on the x and y axes.
void save_quarter_tube(std::filesystem::path const& file, Saved const& how) {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  double const s = how.scale;
  int const o = geo::addPoint(0, 0, 0), p1 = geo::addPoint(s * a, 0, 0),
            p2 = geo::addPoint(s * b, 0, 0), p3 = geo::addPoint(0, s * b, 0),
            p4 = geo::addPoint(0, s * a, 0);
  int const l1 = geo::addLine(p1, p2), l2 = geo::addCircleArc(p2, o, p3), l3 = geo::addLine(p3, p4),
            l4 = geo::addCircleArc(p4, o, p1);
  int const surface = geo::addPlaneSurface({geo::addCurveLoop({l1, l2, l3, l4})});
  for (int const line : {l1, l3})
    geo::mesh::setTransfiniteCurve(line, 4);
  for (int const arc : {l2, l4})
    geo::mesh::setTransfiniteCurve(arc, 9);
  geo::mesh::setTransfiniteSurface(surface);
  if (how.is_recombined)
    geo::mesh::setRecombine(2, surface);
  gmsh::vectorpair out; // top, volume, then the sides of l1 to l4
  geo::extrude({{2, surface}}, 0, 0, s * 5e-3, out, {1}, {}, how.is_recombined);
  geo::synchronize();
  if (how.has_groups) {
    gmsh::model::addPhysicalGroup(3, {out[1].second}, 1);
    int tag = 1;
    for (auto const& [name, entity] : {std::pair{"bottom", surface},
                                       {"top", out[0].second},
                                       {"front", out[2].second},
                                       {"outer", out[3].second},
                                       {"left", out[4].second},
                                       {"bore", out[5].second}}) {
      gmsh::model::addPhysicalGroup(2, {entity}, tag);
      gmsh::model::setPhysicalName(2, tag++, name);
    }
  }
  gmsh::option::setNumber("Mesh.SecondOrderIncomplete", how.incomplete);
  gmsh::option::setNumber("Mesh.ElementOrder", how.order);
  gmsh::option::setNumber("Mesh.MshFileVersion", how.version);
  gmsh::option::setNumber("Mesh.Binary", how.binary);
  gmsh::model::mesh::generate(3);
  gmsh::write(file.string());
  gmsh::finalize();
}

ToolMesh read(std::filesystem::path const& file) {
  return ToolMesh::from_msh(file, {.length_unit = 1e-3, .required_surfaces = {"bore", "left"}});
}

double displacement_of_bore(ToolMesh const& mesh) {
  std::array<bool, 3> const x = {true, false, false}, y = {false, true, false},
                            z = {false, false, true};
  ElasticTool const tool(mesh, {steel},
                         {.surfaces = {{"left", x}, {"front", y}, {"bottom", z}, {"top", z}}});
  auto const u = tool.solve_pressure("bore", 65.7e6).displacement;
  SurfaceTrace const bore = mesh.trace("bore");
  double sum = 0.0;
  for (std::size_t i = 0; i < bore.nodes.size(); ++i)
    sum += tools::radial(bore.positions.col(i), u.col(bore.nodes[i]));
  return sum / bore.nodes.size();
}

// Lame at 65.7 MPa, plane strain: 5.46424 um. Nodes of second order lie on the cylinder, those in
// the middle of faces all but; cells of first order are straight, 1 - cos(pi/32) = 0.5 % inside it
// at mid-side. The rest is the coarse mesh.
TEST(MshFile, GivesATubeItsDisplacement) {
  support::ScratchFolder const folder;
  auto const file = folder.path() / "tube.msh";
  for (auto const& [how, of_area, of_u] : {std::tuple{Saved{}, 1e-5, 1.5e-3},
                                           {Saved{.incomplete = 1}, 1e-5, 1.5e-3},
                                           {Saved{.order = 1}, 7e-3, 2e-2}}) {
    save_quarter_tube(file, how);
    ToolMesh const mesh = read(file);
    EXPECT_EQ(mesh.n_cells(), 24u);
    EXPECT_EQ(mesh.n_nodes(), 17u * 7u * 3u);
    EXPECT_EQ(mesh.n_regions(), 1u);
    EXPECT_TRUE(near::relative(mesh.trace("bore").area(), pi / 2.0 * a * 5e-3, of_area));
    EXPECT_TRUE(near::relative(mesh.trace("top").area(), pi / 4.0 * (b * b - a * a), of_area));
    double const u = displacement_of_bore(mesh);
    EXPECT_TRUE(near::relative(u, 5.46424e-6, of_u));
    RecordProperty("u_at_bore_um_order_" + std::to_string(how.order) + "_incomplete_" +
                       std::to_string(how.incomplete),
                   std::to_string(1e6 * u));
  }
}

// Text holds 16 digits, which is a bit less than binary.
TEST(MshFile, IsTheSameInEveryFormat) {
  support::ScratchFolder const folder;
  auto const file = folder.path() / "tube.msh";
  std::vector<ToolMesh> meshes;
  for (int const binary : {0, 1})
    for (double const version : {2.2, 4.1}) {
      save_quarter_tube(file, {.version = version, .binary = binary});
      meshes.push_back(read(file));
    }
  EXPECT_EQ(meshes[0].hash(), meshes[1].hash());
  EXPECT_EQ(meshes[2].hash(), meshes[3].hash());
  EXPECT_LT((meshes[0].nodes() - meshes[2].nodes()).cwiseAbs().maxCoeff(), 1e-15 * b);
}

TEST(MshFile, IsReadInItsUnit) {
  support::ScratchFolder const folder;
  auto const file = folder.path() / "tube.msh";
  save_quarter_tube(file, {.scale = 1.0});
  EXPECT_TRUE(
      near::relative(ToolMesh::from_msh(file).trace("outer").area(), pi / 2.0 * b * 5e-3, 2e-4));
}

void expect_refused(std::filesystem::path const& file, std::string const& part,
                    MshOptions const& options = {}) {
  expect_refusal([&] { ToolMesh::from_msh(file, options); }, file.string() + ": " + part);
}

TEST(Refusal, OfMshFiles) {
  support::ScratchFolder const folder;
  auto const file = folder.path() / "tube.msh";
  expect_refused(file, "cannot be read");
  support::put_bytes(file, "solid die\nendsolid die\n");
  expect_refused(file, "is no gmsh mesh");
  support::put_bytes(file, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n1 0 0");
  expect_refusal([&] { ToolMesh::from_msh(file); }, file.string() + ": ");
  save_quarter_tube(file, {});
  expect_refused(file, "no physical surface 'boer' (it has bottom, top, front, outer, left, bore",
                 {.required_surfaces = {"bore", "boer"}});
  expect_refused(file, "length unit = 0 m", {.length_unit = 0.0});
  save_quarter_tube(file, {.has_groups = false});
  expect_refused(file, "no physical surfaces");
  save_quarter_tube(file, {.is_recombined = false});
  expect_refused(file, "elements of the kind 'Tetrahedron");
}

// Text files whose one hexahedron, or its surface, is spoilt.
std::string cube(std::string const& cells, std::string const& nodes_of_hexahedron) {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 7 \"skin\"\n"
                     "$EndPhysicalNames\n$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n"
                     "6 1 0 1\n7 1 1 1\n8 0 1 1\n$EndNodes\n$Elements\n" +
                     cells;
  int number = 1;
  if (!nodes_of_hexahedron.empty())
    text += std::to_string(number++) + " 5 2 1 1 " + nodes_of_hexahedron + "\n";
  for (char const* quad : {"1 2 3 4", "5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"})
    text += std::to_string(number++) + " 3 2 7 2 " + quad + "\n";
  return text + "$EndElements\n";
}

TEST(Refusal, OfMeshesInMshFiles) {
  support::ScratchFolder const folder;
  auto const file = folder.path() / "cube.msh";
  support::put_bytes(file, cube("7\n", "1 2 3 4 5 6 7 8"));
  EXPECT_EQ(ToolMesh::from_msh(file).n_nodes(), 27u);
  EXPECT_TRUE(near::relative(ToolMesh::from_msh(file).trace("skin").area(), 6.0, 1e-14));
  support::put_bytes(file, cube("7\n", "5 6 7 8 1 2 3 4"));
  expect_refused(file, "cell 0 at (0.5, 0.5, 0.5) m is inverted");
  support::put_bytes(file, cube("6\n", ""));
  expect_refused(file, "no hexahedra");
}

} // namespace
