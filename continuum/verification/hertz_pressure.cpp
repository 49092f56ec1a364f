#include "continuum/tool/elastic_tool.hpp"
#include "continuum/tool/hex_mesh.hpp"
#include "continuum/verification/problems.hpp"

#include <numbers>

namespace continuum::verification {

namespace {
constexpr double a = 1e-3, force = 1e3, size = 0.1; // radius of contact [m], [N], block [m]
constexpr ElasticMaterial material{.young_modulus = 200e9, .poisson_ratio = 0.3};
constexpr double p0 = 1.5 * force / (std::numbers::pi * a * a); // 477.5 MPa

// A quarter of the body, the load in its corner; top at z = 0. Cells of a/5 there.
ToolMesh quarter_block() {
  std::vector<double> const lines = graded(0.0, size, 13, 170.0);
  std::vector<double> depths;
  for (auto line = lines.rbegin(); line != lines.rend(); ++line)
    depths.push_back(-*line);
  return ToolMesh::from_hexes(
      mesh_block({lines, lines, depths}, [](Eigen::Vector3d const& grid) { return grid; }));
}

Eigen::Vector3d hertz_traction(Eigen::Vector3d const& x, Eigen::Vector3d const& normal) {
  double const rest = 1.0 - x.head<2>().squaredNorm() / (a * a);
  return rest > 0.0 ? Eigen::Vector3d(-p0 * std::sqrt(rest) * normal) : Eigen::Vector3d::Zero();
}
} // namespace

Checks check_hertz_pressure() {
  ElasticTool const tool(
      quarter_block(), {material},
      {.surfaces = {{"left", {true, false, false}}, {"front", {false, true, false}}, {"bottom"}}});
  SurfaceTrace const top = tool.mesh().trace("top");
  auto const loads = tool.spread(top, top.traction_loads(hertz_traction, 8));
  auto const u = tool.solve(loads).displacement;

  Eigen::Index middle = 0;
  tool.mesh().nodes().colwise().norm().minCoeff(&middle);
  double largest_shear = 0.0, below = 0.0;
  for (StressPoint const& point : tool.stress_on("left", u))
    if (point.position.head<2>().norm() < 1e-9 * size) {
      Eigen::Vector3d const principal = principal_stresses(point.stress);
      double const shear = 0.5 * (principal[0] - principal[2]);
      if (shear > largest_shear) {
        largest_shear = shear;
        below = -point.position.z();
      }
    }
  double const nu = material.poisson_ratio;
  std::string const source = "Johnson, Contact Mechanics (1985), section 3.4";
  return {{"Hertz pressure on a block: force [N]", 0.25 * force, -loads.row(2).sum(), 1e-3, source},
          {"Hertz pressure on a block: sinking of the middle [m]",
           3.0 * (1.0 - nu * nu) * force / (4.0 * material.young_modulus * a), -u(2, middle), 0.02,
           source},
          {"Hertz pressure on a block: largest shear stress on the axis [Pa]", 0.310 * p0,
           largest_shear, 0.02, source},
          // Between nodes of the mesh the place is known to half a distance only.
          {"Hertz pressure on a block: depth of that stress [m]", 0.48 * a, below, 0.2, source}};
}

} // namespace continuum::verification
