#pragma once

#include <Eigen/Core>

#include <numbers>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace continuum {

/// How a gmsh file is read.
struct MshOptions {
  double length_unit = 1.0; ///< of its coordinates [m]: 1e-3 for a file in mm
  std::vector<std::string> required_surfaces = {}; ///< names that the caller will ask for
};

/// Points x with (x - point).normal = 0.
struct PlaneShape {
  Eigen::Vector3d point;  ///< [m]
  Eigen::Vector3d normal; ///< any length but 0
};
/// Points at `radius` from the axis through `point`.
struct CylinderShape {
  Eigen::Vector3d point; ///< on the axis [m]
  Eigen::Vector3d axis;  ///< any length but 0
  double radius;         ///< [m], > 0
};
/// The surface of a tool that lies on a shape.
struct NamedShape {
  std::string name;
  std::variant<PlaneShape, CylinderShape> shape;
};

/// How a closed STL becomes a body.
struct StlOptions {
  double cell_size;         ///< edge of the tetrahedra that are made [m], > 0; hexahedra have half
  double gap_tolerance;     ///< largest distance between STL and FE boundary [m], > 0
  double length_unit = 1.0; ///< of the file's coordinates [m]
  double feature_angle = 40.0 / 180.0 * std::numbers::pi; ///< edges sharper than it part patches
                                                          ///< [rad], in (0, pi)
  double shape_tolerance = 1e-5; ///< a patch lies on a shape if all its vertices do within it [m]
  std::vector<NamedShape> surfaces = {};         ///< a patch takes the first that it lies on;
                                                 ///< several patches may take the same
  std::optional<std::string> other_surface = {}; ///< of patches that lie on none
};

} // namespace continuum
