#include "continuum/tool/body_force.hpp"
#include "continuum/tool/hex_mesh.hpp"
#include "continuum/verification/field_errors.hpp"
#include "continuum/verification/problems.hpp"

#include <array>

namespace continuum::verification {

namespace {
constexpr ElasticMaterial material{.young_modulus = 210e9, .poisson_ratio = 0.3};

// u = c g,  g = z sin(k.x):
//   grad g = sin(k.x) e_z + z cos(k.x) k
//   H = grad grad g = cos(k.x) (k e_z^T + e_z k^T) - z sin(k.x) k k^T
// From sigma = lambda (c.grad g) I + G (c grad g^T + grad g c^T) the body force that it needs is
//   b = -div sigma = -(lambda + G) H c - G tr(H) c .
struct Field {
  Eigen::Vector3d c{1e-3, -0.7e-3, 0.5e-3}; // [-], since z is a length
  Eigen::Vector3d k{1.5, 1.1, -0.8};        // [1/m]

  Eigen::Vector3d gradient(Eigen::Vector3d const& x) const {
    return std::sin(k.dot(x)) * Eigen::Vector3d::UnitZ() + x.z() * std::cos(k.dot(x)) * k;
  }
  Eigen::Vector3d displacement(Eigen::Vector3d const& x) const {
    return x.z() * std::sin(k.dot(x)) * c;
  }
  Eigen::Matrix3d stress(Eigen::Vector3d const& x) const {
    Eigen::Matrix3d const slope = c * gradient(x).transpose();
    return material.stress(0.5 * (slope + slope.transpose()));
  }
  Eigen::Vector3d body_force(Eigen::Vector3d const& x) const {
    Eigen::Vector3d const z = Eigen::Vector3d::UnitZ();
    Eigen::Matrix3d const second = std::cos(k.dot(x)) * (k * z.transpose() + z * k.transpose()) -
                                   x.z() * std::sin(k.dot(x)) * k * k.transpose();
    double const lambda = material.lame_lambda(), G = material.shear_modulus();
    return -(lambda + G) * second * c - G * second.trace() * c;
  }
};

// A sector of a ring, 1 to 2 m, with a wavy top.
ToolMesh curved_block(int n) {
  return ToolMesh::from_hexes(
      mesh_block({graded(1.0, 2.0, n, 1.0), graded(0.0, 1.2, n, 1.0), graded(0.0, 1.0, n, 1.0)},
                 [](Eigen::Vector3d const& grid) {
                   double const r = grid.x(), angle = grid.y();
                   return Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle),
                                          grid.z() * (1.0 + 0.2 * std::sin(2.0 * r + angle)));
                 }));
}

FieldErrors errors_with(int n) {
  Field const field;
  ElasticTool const tool(curved_block(n), {material}, Supports::clamped("bottom"));
  Eigen::Matrix3Xd loads =
      body_force_loads(tool.mesh(), [&](Eigen::Vector3d const& x) { return field.body_force(x); });
  SurfaceTrace const all = tool.mesh().boundary(); // what acts on the bottom goes to the support
  loads += tool.spread(
      all, all.traction_loads([&](Eigen::Vector3d const& x, Eigen::Vector3d const& normal) {
        return Eigen::Vector3d(field.stress(x) * normal);
      }));
  return errors_of(tool, tool.solve(loads).displacement,
                   {.displacement = [&](Eigen::Vector3d const& x) { return field.displacement(x); },
                    .stress = [&](Eigen::Vector3d const& x) { return field.stress(x); }});
}
} // namespace

Checks check_manufactured_solution() {
  FieldErrors const coarse = errors_with(5), fine = errors_with(10);
  std::string const source = "manufactured: u = c z sin(k.x) on a curved block";
  return {{"manufactured solution: order of displacement", 3.0,
           std::log2(coarse.displacement / fine.displacement), 0.05, source},
          {"manufactured solution: order of stress", 2.0, std::log2(coarse.stress / fine.stress),
           0.05, source},
          {"manufactured solution: relative error of displacement", 0.0, fine.displacement, 1e-4,
           source},
          {"manufactured solution: relative error of stress", 0.0, fine.stress, 3e-3, source}};
}

} // namespace continuum::verification
