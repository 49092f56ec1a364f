#pragma once

#include "continuum/tool/elastic_material.hpp"
#include "continuum/tool/tool_mesh.hpp"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace continuum {

/// A surface whose nodes do not move along the marked directions x, y, z.
struct SurfaceSupport {
  std::string surface;
  std::array<bool, 3> fixed = {true, true, true};
};

/// A single node of the mesh, held along the marked directions.
struct NodeSupport {
  std::uint32_t node;
  std::array<bool, 3> fixed = {true, true, true};
};

/// How a tool is held.
struct Supports {
  /// `pinned` holds the three rigid motions in the plane by three tangential pins on the rim of the
  /// bottom (die) or back (punch). Under loads that balance in the plane the pins carry nothing and
  /// an axisymmetric breathing stays axisymmetric; under others they are point supports, so for
  /// loads of single grains clamp a surface.
  enum class InPlane { free, pinned };

  std::vector<SurfaceSupport> surfaces = {};
  InPlane in_plane = InPlane::free;
  std::vector<NodeSupport> nodes = {}; ///< for lines and points; a load there is a point load

  static Supports clamped(std::string surface) { return {.surfaces = {{std::move(surface)}}}; }
  /// Axial rollers on the surface, and pins.
  static Supports rollers(std::string surface) {
    return {.surfaces = {{std::move(surface), {false, false, true}}}, .in_plane = InPlane::pinned};
  }
};

/// A static solution. Arrays are 3 x n_nodes, column = node of the mesh.
struct ToolSolution {
  Eigen::Matrix3Xd displacement; ///< [m]
  Eigen::Matrix3Xd reactions;    ///< [N], zero where nothing is held
  double residual;               ///< |f - K u| / |f| on free components
  double imbalance;              ///< |sum loads + sum reactions| / sum |loads|
  double energy;                 ///< 1/2 f.u [J]
};

struct StressPoint {
  Eigen::Vector3d position; ///< [m], undeformed
  Eigen::Matrix3d stress;   ///< Cauchy [Pa], tension positive
  std::uint32_t region;
  double volume; ///< [m^3] that a quadrature point stands for; 0 on a surface

  double von_mises() const { return continuum::von_mises(stress); }
};

/// The largest von Mises stress of a region, at quadrature points and surface nodes.
struct LargestStress {
  StressPoint point;
  std::optional<double> yield_utilisation; ///< von Mises stress / yield strength, if that is known
  std::optional<double> fatigue_utilisation; ///< von Mises stress / fatigue strength, if known
};

/// Small-strain static elasticity of one tool:  K u = f,  K = sum over cells of
///   integral lambda div(v) div(u) + 2 G eps(v):eps(u) dV,
/// with 27-node elements, 3 x 3 x 3 Gauss points, one material a region. K is factorised once
/// (MUMPS, Cholesky); every further load costs a back-substitution. Needs a Session.
class ElasticTool {
public:
  /// @throws InvalidInput   for a bad material, an unknown surface, a count of materials other than
  ///                        the mesh's regions, or supports that leave a rigid motion free
  /// @throws SolverFailure  if the factorisation fails
  ElasticTool(ToolMesh mesh, std::vector<ElasticMaterial> materials, Supports supports);
  ~ElasticTool();
  ElasticTool(ElasticTool&&) noexcept;
  ElasticTool& operator=(ElasticTool&&) noexcept;

  ToolMesh const& mesh() const;
  std::vector<ElasticMaterial> const& materials() const;

  /// Nodal forces on a trace [N], 3 x its nodes, as loads of the whole mesh.
  Eigen::Matrix3Xd spread(SurfaceTrace const& trace, Eigen::Matrix3Xd const& forces) const;

  /// @param loads  nodal forces [N], 3 x n_nodes; what acts on held components goes to the support
  /// @throws SolverFailure if residual or imbalance exceeds 1e-9
  ToolSolution solve(Eigen::Matrix3Xd const& loads) const;
  /// Uniform pressure [Pa], positive into the body, on a named surface.
  ToolSolution solve_pressure(std::string const& surface, double pressure) const;

  /// K u [N]: forces that hold the displacement u [m], 3 x n_nodes, supports ignored.
  Eigen::Matrix3Xd internal_forces(Eigen::Matrix3Xd const& displacement) const;

  /// Stress at the 27 Gauss points of every cell.
  std::vector<StressPoint> stress_in_cells(Eigen::Matrix3Xd const& displacement) const;
  /// Stress at the nodes of a named surface, the mean over its cells that share the node; in the
  /// order of `mesh().trace(surface).nodes`.
  std::vector<StressPoint> stress_on(std::string const& surface,
                                     Eigen::Matrix3Xd const& displacement) const;
  /// One entry a region.
  std::vector<LargestStress> largest_stress(Eigen::Matrix3Xd const& displacement) const;

  /// Components 3 a + c (node a, direction c) that the supports hold.
  std::vector<bool> const& is_held() const;

  /// K condensed onto the free components `keep` (3 a + c, ascending) of the supported tool [N/m].
  Eigen::MatrixXd condensed_stiffness(std::vector<int> const& keep) const;

  /// Of mesh, materials' elastic constants and supports.
  std::uint64_t hash() const;

private:
  struct System;
  std::unique_ptr<System> system_;
};

} // namespace continuum
