#pragma once

#include "continuum/tool/hex_mesh.hpp"

#include <string>

namespace continuum {

/// @param where  what messages call the mesh: its file, or whose it is
/// @throws InvalidInput if there are no cells, counts or numbers do not fit, two vertices coincide,
///         a face has more than two cells, the boundary is not closed (every edge of it between two
///         faces), or a boundary face has no surface or two
void validate(HexMesh const& mesh, std::string const& where);

} // namespace continuum
