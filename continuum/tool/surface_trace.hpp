#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace continuum {

/// The nine biquadratic shape functions of a face at (xi, eta) in [0, 1]^2, node 3 j + i standing
/// at (i/2, j/2). They sum to one and reproduce linear fields.
Eigen::Matrix<double, 9, 1> face_shape(double xi, double eta);
/// Their derivatives: column 0 by xi, column 1 by eta.
Eigen::Matrix<double, 9, 2> face_shape_gradient(double xi, double eta);

/// A face of the FE boundary.
struct TraceFace {
  std::array<std::uint32_t, 9> nodes; ///< of the trace; 3 j + i stands at (xi, eta) = (i/2, j/2)
  std::uint32_t surface;              ///< index into SurfaceTrace::surfaces
};

/// A triangulation of a trace whose vertices are points of the FE surface.
struct TraceTriangles {
  struct Place {
    std::uint32_t face; ///< of the trace; one of those that share the vertex
    double xi, eta;     ///< where on it, in [0, 1]^2
  };
  std::vector<Eigen::Vector3d> vertices = {};               ///< [m]
  std::vector<Place> places = {};                           ///< of each vertex
  std::vector<std::array<std::uint32_t, 3>> triangles = {}; ///< counter-clockwise seen from outside
  std::vector<std::uint32_t> faces = {};                    ///< face that each triangle is part of
  int per_edge = 1;                                         ///< k: a face is cut into k x k x 2
};

/// Named surfaces of a tool as the FE model has them: nodes and second-order faces,
///   x(xi, eta) = sum_a N_a(xi, eta) x_a .
/// The outward normal is along dx/dxi x dx/deta on every face.
struct SurfaceTrace {
  std::vector<std::string> surfaces; ///< names
  std::vector<std::uint32_t> nodes;  ///< number of each node in the tool's mesh, ascending
  Eigen::Matrix3Xd positions;        ///< [m], 3 x n_nodes
  std::vector<TraceFace> faces;

  Eigen::Vector3d position(std::uint32_t face, double xi, double eta) const; ///< [m]
  Eigen::Vector3d normal(std::uint32_t face, double xi, double eta) const;   ///< outward, unit

  /// Area by the 3 x 3 Gauss rule on every face [m^2].
  double area() const;

  /// Consistent nodal forces of a uniform pressure [Pa] that pushes into the body:
  ///   f_a = -p integral N_a n dA   [N], 3 x n_nodes. Exact for these faces.
  Eigen::Matrix3Xd pressure_loads(double pressure) const;

  /// Force per area [Pa] from a position [m] and the outward unit normal there.
  using Traction = std::function<Eigen::Vector3d(Eigen::Vector3d const& position,
                                                 Eigen::Vector3d const& normal)>;
  /// Consistent nodal forces of a traction:  f_a = integral N_a t dA   [N], 3 x n_nodes, by the
  /// 3 x 3 Gauss rule on each of cuts x cuts parts of a face. One part holds a t that is linear on
  /// a flat face exactly; where t has an edge inside a face, more parts find it.
  /// @throws InvalidInput if cuts is not positive
  Eigen::Matrix3Xd traction_loads(Traction const& traction, int cuts = 1) const;

  /// Triangles that leave the FE surface by no more than `tolerance` [m], measured between their
  /// vertices; k is the same on all faces, so a closed trace gives a closed triangulation.
  /// @throws InvalidInput if the tolerance is not positive or needs more than 64 cuts a face
  TraceTriangles triangulate(double tolerance) const;
};

} // namespace continuum
