// Bodies from anyone's hexahedra: what is refused, and loads on them.
#include "continuum/tool/body_force.hpp"
#include "continuum/tool/hex_mesh.hpp"
#include "tests/support/near.hpp"
#include "tests/unit/continuum/refusal.hpp"
#include "tests/unit/continuum/tools.hpp"

#include <limits>

namespace {

using namespace continuum;
using tools::steel;

// 2 x 1 x 1 cells, 3 x 2 x 1 m.
HexMesh two_cubes() {
  return mesh_block({std::vector{0.0, 1.0, 3.0}, {0.0, 2.0}, {0.0, 1.0}},
                    [](Eigen::Vector3d const& grid) { return grid; });
}

TEST(Block, NamesItsSides) {
  ToolMesh const mesh = ToolMesh::from_hexes(two_cubes());
  EXPECT_EQ(mesh.n_nodes(), 5u * 3u * 3u);
  int c = 0;
  for (auto const& [low, high, area] :
       {std::tuple{"left", "right", 2.0}, {"front", "back", 3.0}, {"bottom", "top", 6.0}}) {
    std::array<double, 3> const size = {3.0, 2.0, 1.0};
    EXPECT_TRUE((mesh.trace(low).positions.row(c).array() == 0.0).all());
    EXPECT_TRUE((mesh.trace(high).positions.row(c).array() == size[c]).all());
    EXPECT_TRUE(near::relative(mesh.trace(low).area(), area, 1e-14));
    EXPECT_EQ(mesh.trace(high).normal(0, 0.2, 0.3)[c], 1.0);
    ++c;
  }
}

TEST(Refusal, OfBlocks) {
  auto const same = [](Eigen::Vector3d const& grid) { return grid; };
  expect_refusal(
      [&] {
        mesh_block({std::vector{0.0}, {0.0, 1.0}, {0.0, 1.0}}, same);
      },
      "1 grid lines in one direction");
  expect_refusal(
      [&] {
        mesh_block({std::vector{0.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}}, same);
      },
      "not ascending");
}

void expect_refused(std::function<void(HexMesh&)> const& damage, std::string const& part) {
  HexMesh mesh = two_cubes();
  damage(mesh);
  expect_refusal([&] { ToolMesh::from_hexes(mesh, "pin.msh"); }, "pin.msh: " + part);
}

TEST(Refusal, OfHexahedra) {
  expect_refused([](HexMesh& mesh) { mesh = {}; }, "no hexahedra");
  expect_refused([](HexMesh& mesh) { mesh.nodes.pop_back(); },
                 "2 cells, nodes of 1 and regions of");
  expect_refused([](HexMesh& mesh) { mesh.regions.pop_back(); },
                 "2 cells, nodes of 2 and regions of 1");
  expect_refused([](HexMesh& mesh) { mesh.cells[1][3] = 12; }, "a cell has a vertex beyond the 12");
  expect_refused(
      [](HexMesh& mesh) {
        mesh.pins = {{3, 5}};
      },
      "a pin holds component 5 of vertex 3");
  expect_refused(
      [](HexMesh& mesh) { mesh.nodes[1][13].y() = std::numeric_limits<double>::quiet_NaN(); },
      "a node has no finite position");
  expect_refused([](HexMesh& mesh) { mesh.surfaces[2] = "left"; },
                 "two surfaces have the same name");
  expect_refused([](HexMesh& mesh) { mesh.boundary.pop_back(); }, "the boundary face at (");
  expect_refused([](HexMesh& mesh) { mesh.boundary.back().surface = 6; },
                 "a face of surface 6 of 6");
  expect_refused(
      [](HexMesh& mesh) {
        mesh.boundary.push_back(mesh.boundary[0]);
        mesh.boundary.back().surface = 1;
      },
      "a face is part of 'left' and 'right'");
  expect_refused(
      [](HexMesh& mesh) {
        mesh.boundary.push_back({{1, 4, 7, 10}, 0});
      },
      "surface 'left' has a face that is no face of the body's boundary");
  expect_refused([](HexMesh& mesh) { mesh.nodes[0][13].x() += 3.0; }, "cell 0 at (");
  expect_refused([](HexMesh& mesh) { mesh.nodes[1][12].z() += 0.01; },
                 "cell 0 has a node at (1, 1, 0.5) m where its neighbour has (1, 1, 0.51) m");
}

// The second cube with vertices of its own on the common face.
TEST(Refusal, OfTornBodies) {
  expect_refused(
      [](HexMesh& mesh) {
        for (unsigned& vertex : mesh.cells[1])
          if (mesh.vertices[vertex].x() == 1.0) {
            mesh.vertices.push_back(mesh.vertices[vertex]);
            vertex = mesh.vertices.size() - 1;
          }
      },
      "vertices 1 and 12 coincide at (1, 0, 0) m");
}

TEST(Refusal, OfCellsThatOverlapOrTouchInAnEdge) {
  expect_refused(
      [](HexMesh& mesh) {
        mesh.cells.push_back(mesh.cells[0]);
        mesh.nodes.push_back(mesh.nodes[0]);
        mesh.regions.push_back(0);
      },
      "a face at (");
  HexMesh four = mesh_block({std::vector{0.0, 1.0, 2.0}, {0.0, 1.0, 2.0}, {0.0, 1.0}},
                            [](Eigen::Vector3d const& grid) { return grid; });
  for (auto* const list : {&four.cells[1], &four.cells[2]}) // leaves two that share an edge
    *list = list == &four.cells[1] ? four.cells[3] : four.cells[0];
  four.cells = {four.cells[0], four.cells[1]};
  four.nodes = {four.nodes[0], four.nodes[3]};
  four.regions.resize(2);
  expect_refusal([&] { ToolMesh::from_hexes(four); }, "lies on 4 boundary faces");
}

// b = (1, y, x z): sums and first moment integrated by hand over 3 x 2 x 1 m.
TEST(BodyForce, IsItsIntegral) {
  ToolMesh const mesh = ToolMesh::from_hexes(two_cubes());
  auto const loads = body_force_loads(
      mesh, [](Eigen::Vector3d const& x) { return Eigen::Vector3d(1.0, x.y(), x.x() * x.z()); });
  EXPECT_TRUE(near::relative(loads.row(0).sum(), 6.0, 1e-13));
  EXPECT_TRUE(near::relative(loads.row(1).sum(), 6.0, 1e-13)); // 3 * 1 * 2^2/2
  EXPECT_TRUE(near::relative(loads.row(2).sum(), 4.5, 1e-13)); // 3^2/2 * 2 * 1/2
  // integral x (x z) dV = 3^3/3 * 2 * 1/2
  EXPECT_TRUE(near::relative(loads.row(2).dot(mesh.nodes().row(0)), 9.0, 1e-13));
}

// A column that hangs by its own weight: u_z(H) at the free end is rho g H^2 / (2 E), nu = 0.
TEST(BodyForce, StretchesAHangingColumn) {
  ElasticTool const tool(ToolMesh::from_hexes(two_cubes()),
                         {{.young_modulus = 2e9, .poisson_ratio = 0.0}}, Supports::clamped("top"));
  auto const u = tool.solve(body_force_loads(tool.mesh(),
                                             [](Eigen::Vector3d const&) {
                                               return Eigen::Vector3d(0.0, 0.0, -7800.0 * 9.81);
                                             }))
                     .displacement;
  for (std::uint32_t const node : tool.mesh().trace("bottom").nodes)
    EXPECT_TRUE(near::relative(u(2, node), -7800.0 * 9.81 / 4e9, 1e-10));
}

// 1 Pa on the strip x < 0.3 m of 2 m: its edge lies inside a face, so parts find it the better.
TEST(Traction, FindsAnEdgeInsideAFaceByCuts) {
  SurfaceTrace const top = ToolMesh::from_hexes(two_cubes()).trace("top");
  auto const strip = [](Eigen::Vector3d const& x, Eigen::Vector3d const& normal) {
    return Eigen::Vector3d((x.x() < 0.3 ? -1.0 : 0.0) * normal);
  };
  EXPECT_GT(std::abs(top.traction_loads(strip, 1).row(2).sum() + 0.6), 0.03);
  EXPECT_LT(std::abs(top.traction_loads(strip, 40).row(2).sum() + 0.6), 0.01);
  expect_refusal([&] { top.traction_loads(strip, 0); }, "cut 0 times");
}

TEST(Traction, OfAPressureIsThatOfThePressure) {
  SurfaceTrace const bore = tools::small_die().trace("bore");
  auto const pressure = [](Eigen::Vector3d const&, Eigen::Vector3d const& normal) {
    return Eigen::Vector3d(-65.7e6 * normal);
  };
  auto const expected = bore.pressure_loads(65.7e6);
  EXPECT_LT((bore.traction_loads(pressure) - expected).norm(), 1e-13 * expected.norm());
}

// Three nodes that hold six components are a statically determinate support: stress-free but for
// the load, here of the pressure on two opposite sides.
TEST(Supports, OfNodesHoldThemAlone) {
  ToolMesh const mesh = ToolMesh::from_hexes(two_cubes());
  auto const node_at = [&](Eigen::Vector3d const& x) {
    Eigen::Index node = 0;
    (mesh.nodes().colwise() - x).colwise().norm().minCoeff(&node);
    return static_cast<std::uint32_t>(node);
  };
  ElasticTool const tool(mesh, {steel},
                         {.nodes = {{node_at({0.0, 0.0, 0.0})},
                                    {node_at({3.0, 0.0, 0.0}), {false, true, true}},
                                    {node_at({0.0, 2.0, 0.0}), {false, false, true}}}});
  EXPECT_EQ(std::ranges::count(tool.is_held(), true), 6);
  SurfaceTrace const left = mesh.trace("left"), right = mesh.trace("right");
  auto const u = tool.solve(tool.spread(left, left.pressure_loads(1e6)) +
                            tool.spread(right, right.pressure_loads(1e6)))
                     .displacement;
  for (std::uint32_t const node : right.nodes)
    EXPECT_TRUE(near::relative(u(0, node), -1e6 * 3.0 / 210e9, 1e-10));
  expect_refusal([&] { ElasticTool(mesh, {steel}, {.nodes = {{45}}}); },
                 "a support at node 45 of a tool of 45 nodes");
}

} // namespace
