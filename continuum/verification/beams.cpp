#include "continuum/tool/elastic_tool.hpp"
#include "continuum/tool/hex_mesh.hpp"
#include "continuum/verification/problems.hpp"

namespace continuum::verification {

namespace {
constexpr double length = 0.2, width = 20e-3, height = 10e-3; // [m]
constexpr double force = 10.0;                                // [N]
constexpr ElasticMaterial material{.young_modulus = 200e9, .poisson_ratio = 0.3};
constexpr double area = width * height, second_moment = width * height * height * height / 12.0;

Eigen::Index node_at(ToolMesh const& mesh, Eigen::Vector3d const& x) {
  Eigen::Index node = 0;
  (mesh.nodes().colwise() - x).colwise().norm().minCoeff(&node);
  return node;
}

double mean_z(SurfaceTrace const& end, Eigen::Matrix3Xd const& u) {
  double sum = 0.0;
  for (std::uint32_t const node : end.nodes)
    sum += u(2, node);
  return sum / end.nodes.size();
}

// A beam along x. A clamp holds its section along the beam only and gives it its shear as a
// traction, since the beam of the formula is free to contract across; the single nodes against
// shift and turn across carry nothing.
// @param held_at_end  what a clamp, or a plane of symmetry, holds at the loaded end
// @return             mean deflection of that end against the clamp [m]
double deflection(double beam_length, double end_force, std::array<bool, 3> held_at_end) {
  ToolMesh const mesh = ToolMesh::from_hexes(mesh_block(
      {graded(0.0, beam_length, 20, 1.0), graded(0.0, width, 2, 1.0), graded(0.0, height, 2, 1.0)},
      [](Eigen::Vector3d const& grid) { return grid; }));
  std::array<bool, 3> constexpr x = {true, false, false}, yz = {false, true, true},
                                z = {false, false, true};
  auto const node = [&](double y) {
    return static_cast<std::uint32_t>(node_at(mesh, {0.0, y, 0.5 * height}));
  };
  ElasticTool const tool(mesh, {material},
                         {.surfaces = {{"left", x}, {"right", held_at_end}},
                          .nodes = {{node(0.5 * width), yz}, {node(width), z}}});
  Eigen::Matrix3Xd loads = Eigen::Matrix3Xd::Zero(3, mesh.n_nodes());
  SurfaceTrace const clamp = mesh.trace("left"), end = mesh.trace("right");
  for (auto const& [trace, sign] : {std::pair{&clamp, -1.0}, {&end, 1.0}})
    loads += tool.spread(*trace, trace->traction_loads([&](auto const&, auto const&) {
      return Eigen::Vector3d(0.0, 0.0, sign * end_force / area);
    }));
  auto const u = tool.solve(loads).displacement;
  return mean_z(end, u) - mean_z(clamp, u);
}
} // namespace

Checks check_beams() {
  double const cubed = force * length * length * length,
               bending = material.young_modulus * second_moment;
  double const nu = material.poisson_ratio, kappa = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
  double const shear = force * length / (kappa * material.shear_modulus() * area);
  std::string const source = "Timoshenko's beam; Cowper, J. Appl. Mech. 33 (1966)";
  // Half of the clamped beam: on the plane of symmetry x is held and half of the force acts.
  return {{"cantilever: deflection of the end [m]", cubed / (3.0 * bending) + shear,
           deflection(length, force, {false, false, false}), 0.01, source},
          {"beam clamped at both ends: deflection of the middle [m]",
           cubed / (192.0 * bending) + 0.25 * shear,
           deflection(0.5 * length, 0.5 * force, {true, false, false}), 0.01, source}};
}

} // namespace continuum::verification
