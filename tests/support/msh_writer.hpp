#pragma once

#include "continuum/tool/hex_mesh.hpp"

#include <filesystem>
#include <fstream>

namespace support {

/// Writes a mesh as gmsh text, version 2.2, with hexahedra of first order: physical volume r + 1 is
/// region r, physical surfaces have the mesh's names.
/// @param per_metre  units of the file in a metre
inline void save_msh(continuum::HexMesh const& mesh, std::filesystem::path const& file,
                     double per_metre = 1e3) {
  std::ofstream out(file);
  out.precision(17);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" << mesh.surfaces.size() << '\n';
  for (std::size_t s = 0; s < mesh.surfaces.size(); ++s)
    out << "2 " << s + 1 << " \"" << mesh.surfaces[s] << "\"\n";
  out << "$EndPhysicalNames\n$Nodes\n" << mesh.vertices.size() << '\n';
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    out << v + 1 << ' ' << (per_metre * mesh.vertices[v]).transpose() << '\n';
  out << "$EndNodes\n$Elements\n" << mesh.boundary.size() + mesh.cells.size() << '\n';
  std::size_t tag = 0;
  // gmsh goes round a face where we go line by line
  for (auto const& quad : mesh.boundary) {
    out << ++tag << " 3 2 " << quad.surface + 1 << ' ' << quad.surface + 1;
    for (int const i : {0, 1, 3, 2})
      out << ' ' << quad.vertices[i] + 1;
    out << '\n';
  }
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    out << ++tag << " 5 2 " << mesh.regions[c] + 1 << ' ' << mesh.regions[c] + 1;
    for (int const i : {0, 1, 3, 2, 4, 5, 7, 6})
      out << ' ' << mesh.cells[c][i] + 1;
    out << '\n';
  }
  out << "$EndElements\n";
}

} // namespace support
