#pragma once

#include "continuum/tool/hex_mesh.hpp"

#include <array>
#include <map>
#include <vector>

namespace continuum {

/// Straight tetrahedra, each cut into four hexahedra by its middle and those of its faces and
/// edges. The cut is the same up to an affine map in every tetrahedron, so that no hexahedron is
/// inverted if no tetrahedron is.
class TetSubdivision {
public:
  /// @param points  [m]; corners count from zero
  explicit TetSubdivision(std::vector<Eigen::Vector3d> points);

  void add_tetrahedron(std::array<unsigned, 4> corners); ///< of either orientation
  /// A triangle of the boundary becomes three quadrilaterals of the surface.
  void add_triangle(std::array<unsigned, 3> const& corners, unsigned surface);
  /// Straight hexahedra, of region 0.
  HexMesh take(std::vector<std::string> surfaces);

private:
  /// The vertex in the middle of points, made once.
  unsigned middle(std::vector<unsigned> corners);

  HexMesh mesh_;
  std::map<std::vector<unsigned>, unsigned> middles_;
};

} // namespace continuum
