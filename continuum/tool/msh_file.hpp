#pragma once

#include "continuum/tool/hex_mesh.hpp"
#include "continuum/tool/mesh_files.hpp"

#include <filesystem>

namespace continuum {

/// Hexahedra and named surfaces of a gmsh file; see ToolMesh::from_msh.
HexMesh read_msh(std::filesystem::path const& file, MshOptions const& options);

} // namespace continuum
