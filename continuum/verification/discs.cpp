#include "continuum/tool/elastic_tool.hpp"
#include "continuum/verification/problems.hpp"

#include <numbers>

namespace continuum::verification {

namespace {
using std::numbers::pi;
constexpr double a = 50e-3, h = 5e-3, c = 10e-3; // radius, thickness, radius of the load [m]
constexpr double force = 1e3;                    // [N]
constexpr ElasticMaterial material{.young_modulus = 200e9, .poisson_ratio = 0.3};

double pressure(double r) {
  double const rest = 1.0 - r * r / (c * c);
  return rest > 0.0 ? 3.0 * force / (pi * c * c) * rest * rest : 0.0;
}

ToolMesh disc() {
  return ToolMesh::punch({.radius = a, .length = h},
                         {.around = 64, .rings = 6, .along = 2, .growth = 1.0});
}

std::uint32_t middle_of(ToolMesh const& mesh) {
  Eigen::Index middle = 0;
  (mesh.nodes().colwise() - Eigen::Vector3d(0.0, 0.0, -0.5 * h)).colwise().norm().minCoeff(&middle);
  return middle;
}

Eigen::Matrix3Xd displacement(ElasticTool const& tool, double shear_on_side) {
  SurfaceTrace const face = tool.mesh().trace("face"), side = tool.mesh().trace("side");
  auto const push = [](Eigen::Vector3d const& x, Eigen::Vector3d const& normal) {
    return Eigen::Vector3d(-pressure(x.head<2>().norm()) * normal);
  };
  auto const carry = [&](auto const&, auto const&) {
    return Eigen::Vector3d(0.0, 0.0, shear_on_side);
  };
  return tool
      .solve(tool.spread(face, face.traction_loads(push, 4)) +
             tool.spread(side, side.traction_loads(carry)))
      .displacement;
}

// Held along z on its whole side the plate still turns there: its side moves in the plane only.
double deflection_simply_supported() {
  ElasticTool const tool(disc(), {material}, Supports::rollers("side"));
  return -displacement(tool, 0.0)(2, middle_of(tool.mesh()));
}

// The clamp of the formula holds slope and middle plane: the side is held in the plane, carries its
// shear as a traction, and may thicken. Against the middle, which is held and carries nothing.
double deflection_clamped() {
  ToolMesh const mesh = disc();
  ElasticTool const tool(mesh, {material},
                         {.surfaces = {{"side", {true, true, false}}},
                          .nodes = {{middle_of(mesh), {false, false, true}}}});
  auto const u = displacement(tool, force / (2.0 * pi * a * h));
  SurfaceTrace const side = mesh.trace("side");
  double sum = 0.0;
  int n = 0;
  for (std::size_t i = 0; i < side.nodes.size(); ++i)
    if (std::abs(side.positions(2, i) + 0.5 * h) < 1e-9) {
      sum += u(2, side.nodes[i]);
      ++n;
    }
  return sum / n;
}
} // namespace

Checks check_discs() {
  double const nu = material.poisson_ratio,
               D = material.young_modulus * h * h * h / (12.0 * (1.0 - nu * nu));
  double const shear = force / (2.0 * pi * 5.0 / 6.0 * material.shear_modulus() * h) *
                       (std::log(a / c) + 11.0 / 12.0);
  double const clamped =
      force / (8.0 * pi * D) * (a * a / 2.0 - c * c / 4.0 * std::log(a / c) - 25.0 / 96.0 * c * c);
  double const supported = force / (16.0 * pi * D) *
                           ((3.0 + nu) / (1.0 + nu) * (a * a - c * c / 4.0) -
                            c * c / 2.0 * std::log(a / c) - 13.0 / 48.0 * c * c);
  std::string const source =
      "Timoshenko, Woinowsky-Krieger, Theory of Plates and Shells, section 19; Mindlin's shear";
  return {{"clamped disc: deflection of the middle [m]", clamped + shear, deflection_clamped(),
           0.01, source},
          {"simply supported disc: deflection of the middle [m]", supported + shear,
           deflection_simply_supported(), 0.01, source}};
}

} // namespace continuum::verification
