#include "continuum/verification/field_errors.hpp"
#include "continuum/verification/lame_tube.hpp"
#include "continuum/verification/problems.hpp"

#include <array>

namespace continuum::verification {

namespace {
constexpr double inner = 11.025e-3, outer = 30e-3; // the seed press's bore, its die's outside [m]
constexpr ElasticMaterial steel{.young_modulus = 210e9, .poisson_ratio = 0.3};

double radial(Eigen::Vector3d const& x, Eigen::Vector3d const& u) {
  return x.head<2>().dot(u.head<2>()) / x.head<2>().norm();
}

// Mean over the nodes of the bore.
double radial_displacement_of_bore(ElasticTool const& tool, Eigen::Matrix3Xd const& u) {
  SurfaceTrace const bore = tool.mesh().trace("bore");
  double sum = 0.0;
  for (std::size_t i = 0; i < bore.nodes.size(); ++i)
    sum += radial(bore.positions.col(i), u.col(bore.nodes[i]));
  return sum / bore.nodes.size();
}

double von_mises_of_bore(ElasticTool const& tool, Eigen::Matrix3Xd const& u) {
  double sum = 0.0;
  auto const points = tool.stress_on("bore", u);
  for (StressPoint const& point : points)
    sum += point.von_mises();
  return sum / points.size();
}

ElasticTool tube_in_plane_strain(int n) {
  return ElasticTool(
      ToolMesh::die({.bore_radius = inner, .outer_radius = outer, .height = 5e-3},
                    {.around = 8 * n, .through_wall = 2 * n, .along = 1, .growth = 1.0}),
      {steel},
      {.surfaces = {{"bottom", {false, false, true}}, {"top", {false, false, true}}},
       .in_plane = Supports::InPlane::pinned});
}
} // namespace

Checks check_tube_in_plane_strain() {
  constexpr double pressure = 65.7e6;
  LameTube const tube{inner, outer, pressure, 0.0, steel};
  ExactField const exact{.displacement =
                             [&](Eigen::Vector3d const& x) {
                               double const r = x.head<2>().norm();
                               return Eigen::Vector3d(tube.displacement(r) / r *
                                                      Eigen::Vector3d(x.x(), x.y(), 0.0));
                             },
                         .stress = [&](Eigen::Vector3d const& x) { return tube.stress(x); }};
  std::array<FieldErrors, 2> errors;
  double at_bore = 0.0, mises = 0.0;
  for (int const level : {0, 1}) {
    ElasticTool const tool = tube_in_plane_strain(4 << level);
    auto const u = tool.solve_pressure("bore", pressure).displacement;
    errors[level] = errors_of(tool, u, exact);
    at_bore = radial_displacement_of_bore(tool, u);
    mises = von_mises_of_bore(tool, u);
  }
  std::string const source = "Lame; Timoshenko, Goodier, Theory of Elasticity, section 28";
  return {
      {"tube, plane strain: u_r at the bore [m]", tube.displacement(inner), at_bore, 1e-5, source},
      {"tube, plane strain: von Mises stress at the bore [Pa]",
       von_mises(tube.stress({inner, 0.0, 0.0})), mises, 3e-3, source},
      {"tube, plane strain: order of displacement", 3.0,
       std::log2(errors[0].displacement / errors[1].displacement), 0.03, source},
      {"tube, plane strain: order of stress", 2.0, std::log2(errors[0].stress / errors[1].stress),
       0.03, source}};
}

Checks check_tube_with_free_ends() {
  constexpr double pressure = 30e6;
  constexpr ElasticMaterial material{.young_modulus = 200e9, .poisson_ratio = 0.3};
  ElasticTool const tool(
      ToolMesh::die({.bore_radius = inner, .outer_radius = outer, .height = 5e-3},
                    {.around = 32, .through_wall = 6, .along = 1}),
      {material}, Supports::rollers("bottom"));
  double const squares = (outer * outer + inner * inner) / (outer * outer - inner * inner);
  return {{"tube, free ends: u_r at the bore [m]",
           pressure * inner / material.young_modulus * (squares + material.poisson_ratio),
           radial_displacement_of_bore(tool, tool.solve_pressure("bore", pressure).displacement),
           2e-4, "Lame; Timoshenko, Goodier, Theory of Elasticity, section 28"}};
}

} // namespace continuum::verification
