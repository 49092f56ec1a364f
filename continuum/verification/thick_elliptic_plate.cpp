#include "continuum/tool/elastic_tool.hpp"
#include "continuum/tool/hex_mesh.hpp"
#include "continuum/verification/problems.hpp"

#include <numbers>

namespace continuum::verification {

namespace {
constexpr double thickness = 0.6; // [m]

// Grid: from the inner to the outer ellipse, from the x to the y axis, upwards.
ToolMesh quarter_plate() {
  return ToolMesh::from_hexes(mesh_block(
      {graded(0.0, 1.0, 12, 4.0), graded(0.0, 0.5 * std::numbers::pi, 14, 3.0),
       graded(0.0, thickness, 8, 1.0)},
      [](Eigen::Vector3d const& grid) {
        Eigen::Vector2d const direction(std::cos(grid.y()), std::sin(grid.y()));
        Eigen::Vector2d const inside = direction.cwiseProduct(Eigen::Vector2d(2.0, 1.0)),
                              outside = direction.cwiseProduct(Eigen::Vector2d(3.25, 2.75));
        Eigen::Vector2d const point = (1.0 - grid.x()) * inside + grid.x() * outside;
        return Eigen::Vector3d(point.x(), point.y(), grid.z());
      }));
}

// Points of the benchmark: DCD'C' on the x axis, ABA'B' on the y axis, BCB'C' the outer edge.
Supports supports_of(ToolMesh const& mesh) {
  Supports supports{.surfaces = {{"front", {false, true, false}},
                                 {"back", {true, false, false}},
                                 {"right", {true, true, false}}}};
  SurfaceTrace const outer = mesh.trace("right");
  for (std::size_t i = 0; i < outer.nodes.size(); ++i)
    if (std::abs(outer.positions(2, i) - 0.5 * thickness) < 1e-9)
      supports.nodes.push_back({outer.nodes[i], {false, false, true}});
  return supports;
}
} // namespace

Checks check_thick_elliptic_plate() {
  ToolMesh const mesh = quarter_plate();
  ElasticTool const tool(mesh, {{.young_modulus = 210e9, .poisson_ratio = 0.3}}, supports_of(mesh));
  auto const u = tool.solve_pressure("top", 1e6).displacement;
  Eigen::Vector3d const d(2.0, 0.0, thickness);
  double stress = std::nan("");
  for (StressPoint const& point : tool.stress_on("top", u))
    if ((point.position - d).norm() < 1e-9)
      stress = point.stress(1, 1);
  return {{"NAFEMS LE10, thick elliptic plate: sigma_yy at D [Pa]", -5.38e6, stress, 0.01,
           "The Standard NAFEMS Benchmarks, TNSB Rev. 3 (1990), LE10"}};
}

} // namespace continuum::verification
