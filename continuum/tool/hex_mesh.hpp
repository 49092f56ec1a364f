#pragma once

#include "continuum/tool/tool_shape.hpp"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace continuum {

/// One component of one vertex, held against rigid motion.
struct Pin {
  unsigned vertex;
  int component;
};

/// A hexahedral mesh of second order as its generator knows it: who is on which surface follows
/// from the counting, never from coordinates.
struct HexMesh {
  struct Quad {
    std::array<unsigned, 4> vertices; ///< lexicographic
    unsigned surface;
  };
  /// Positions [m] of a cell's 27 nodes; 9 k + 3 j + i stands at (i/2, j/2, k/2) of the cell.
  using CellNodes = std::array<Eigen::Vector3d, 27>;

  std::vector<Eigen::Vector3d> vertices = {};      ///< [m]
  std::vector<std::array<unsigned, 8>> cells = {}; ///< lexicographic, right-handed
  std::vector<CellNodes> nodes = {};      ///< of each cell; cells that share a node agree in it
  std::vector<unsigned> regions = {};     ///< material of each cell
  std::vector<Quad> boundary = {};        ///< every boundary face once
  std::vector<std::string> surfaces = {}; ///< names
  std::vector<Pin> pins =
      {}; ///< tangential: they hold the rigid motions in the plane, not the breathing
};

/// @throws InvalidInput if a length or a count cannot be built
HexMesh mesh_die(DieShape const& shape, DieCells const& cells);
HexMesh mesh_punch(PunchShape const& shape, PunchCells const& cells);

/// Three ascending lists of grid lines, at least two each.
using GridLines = std::array<std::vector<double>, 3>;
/// From grid coordinates to a position [m]; right-handed.
using Placement = std::function<Eigen::Vector3d(Eigen::Vector3d const&)>;

/// A curved box: every node of the grid, those half way between its lines too, where `place` puts
/// it. Surfaces: left, right (first and last line of the first direction), front, back (second),
/// bottom, top (third). No pins.
/// @throws InvalidInput if lines are fewer than two or do not ascend
HexMesh mesh_block(GridLines const& lines, Placement const& place);

/// n + 1 points from `from` to `to`, cell sizes a geometric series whose last is `growth` times the
/// first.
std::vector<double> graded(double from, double to, int n, double growth);

/// The 27 nodes of a cell from a function of (i, j, k), each 0, 1 or 2.
template <class Position> HexMesh::CellNodes cell_nodes(Position const& position) {
  HexMesh::CellNodes nodes;
  for (unsigned k = 0; k < 3; ++k)
    for (unsigned j = 0; j < 3; ++j)
      for (unsigned i = 0; i < 3; ++i)
        nodes[9 * k + 3 * j + i] = position(i, j, k);
  return nodes;
}

} // namespace continuum
