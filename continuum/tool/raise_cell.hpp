#pragma once

#include "continuum/tool/hex_mesh.hpp"

#include <array>

namespace continuum {

/// Positions of the nodes that a cell of lower order lacks. On a face, and in the cell, they follow
/// from corners and mid-sides as in the serendipity element: 1/2 sides - 1/4 corners of a face,
/// 1/4 sides - 1/4 corners of a cell. With straight sides these are the means.
/// @param is_known  all corners at least
void raise_cell(HexMesh::CellNodes& nodes, std::array<bool, 27> const& is_known);

/// A corner of a cell as a node: those that all cells know.
constexpr bool is_corner(unsigned node) {
  return node % 3 != 1 && node / 3 % 3 != 1 && node / 9 != 1;
}

} // namespace continuum
