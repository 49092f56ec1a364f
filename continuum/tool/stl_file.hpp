#pragma once

#include "continuum/tool/hex_mesh.hpp"
#include "continuum/tool/mesh_files.hpp"

#include <filesystem>

namespace continuum {

struct StlBody {
  HexMesh mesh;
  double largest_gap; ///< between STL and FE boundary [m]
};

/// Hexahedra inside a closed STL; see ToolMesh::from_stl.
StlBody mesh_stl(std::filesystem::path const& file, StlOptions const& options);

} // namespace continuum
