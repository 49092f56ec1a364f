#include "continuum/tool/elastic_tool.hpp"
#include "continuum/tool/hex_mesh.hpp"
#include "continuum/verification/problems.hpp"

namespace continuum::verification {

Checks check_column() {
  constexpr double pressure = 65.72e6, height = 20e-3;
  constexpr ElasticMaterial material{.young_modulus = 200e9, .poisson_ratio = 0.3};
  std::array<bool, 3> constexpr x = {true, false, false}, y = {false, true, false},
                                z = {false, false, true};
  ElasticTool const tool(
      ToolMesh::from_hexes(mesh_block(
          {graded(0.0, 8e-3, 2, 1.7), graded(0.0, 10e-3, 2, 1.0), graded(0.0, height, 3, 2.0)},
          [](Eigen::Vector3d const& grid) { return grid; })),
      {material},
      {.surfaces = {{"left", x}, {"right", x}, {"front", y}, {"back", y}, {"bottom", z}}});
  auto const u = tool.solve_pressure("top", pressure).displacement;
  double sum = 0.0, side = 0.0;
  SurfaceTrace const top = tool.mesh().trace("top");
  for (std::uint32_t const node : top.nodes)
    sum -= u(2, node) / top.nodes.size();
  auto const stresses = tool.stress_in_cells(u);
  for (StressPoint const& point : stresses)
    side += point.stress(0, 0) / stresses.size();
  double const nu = material.poisson_ratio;
  return {
      {"column in a smooth box: shortening [m]",
       pressure * height * (1.0 + nu) * (1.0 - 2.0 * nu) / (material.young_modulus * (1.0 - nu)),
       sum, 1e-10, "Hooke's law at uniaxial strain"},
      {"column in a smooth box: stress on the sides [Pa]", -nu / (1.0 - nu) * pressure, side, 1e-10,
       "Hooke's law at uniaxial strain"}};
}

} // namespace continuum::verification
