#pragma once

#include "continuum/tool/hex_mesh.hpp"
#include "continuum/tool/mesh_files.hpp"
#include "continuum/tool/triangle_distance.hpp"

#include <optional>
#include <vector>

namespace continuum {

/// Gives every cell its 27 nodes between its vertices, with straight sides.
void straighten(HexMesh& mesh);

/// Moves the nodes of boundary faces, middles of sides and faces as well, onto the cylinders of
/// their surfaces, square to the axis; the cells behind them follow. A mesh whose vertices lie on
/// the facets of a drawing then has the round surface that the facets stand for.
/// @param cylinders  of each surface; nothing for one that stays as it is
void curve_onto(HexMesh& mesh, std::vector<std::optional<CylinderShape>> const& cylinders);

/// The boundary as triangles between all its nodes: eight a face.
Triangles skin_of(HexMesh const& mesh);

} // namespace continuum
