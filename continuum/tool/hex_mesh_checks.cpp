#include "continuum/tool/hex_mesh_checks.hpp"

#include "continuum/expect.hpp"
#include "continuum/tool/quote.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace continuum {

namespace {
using Corners = std::array<unsigned, 4>; // of a face, ascending

Corners sorted(Corners corners) {
  std::ranges::sort(corners);
  return corners;
}

// Face 2 c + end of a cell: its corners at that end of the direction c, lexicographic.
Corners face_of(std::array<unsigned, 8> const& cell, unsigned face) {
  Corners corners;
  for (unsigned v = 0, n = 0; v < 8; ++v)
    if ((v >> face / 2) % 2 == face % 2)
      corners[n++] = cell[v];
  return corners;
}

std::string place(HexMesh const& mesh, unsigned vertex) {
  return quote_position(mesh.vertices[vertex]);
}

void validate_counts(HexMesh const& mesh, std::string const& where) {
  VALIDATE(!mesh.cells.empty(),
           where + ": no hexahedra (a tool needs a volume). Was only its surface meshed?");
  VALIDATE(mesh.nodes.size() == mesh.cells.size() && mesh.regions.size() == mesh.cells.size(),
           where + ": " + std::to_string(mesh.cells.size()) + " cells, nodes of " +
               std::to_string(mesh.nodes.size()) + " and regions of " +
               std::to_string(mesh.regions.size()) + " (each cell has both). Is one list short?");
  for (auto const& cell : mesh.cells)
    VALIDATE(std::ranges::all_of(cell, [&](unsigned v) { return v < mesh.vertices.size(); }),
             where + ": a cell has a vertex beyond the " + std::to_string(mesh.vertices.size()) +
                 " (there is no place for it). Is the numbering from zero?");
  for (Pin const& pin : mesh.pins)
    VALIDATE(pin.vertex < mesh.vertices.size() && pin.component >= 0 && pin.component < 3,
             where + ": a pin holds component " + std::to_string(pin.component) + " of vertex " +
                 std::to_string(pin.vertex) + " (there is none). Is the numbering from zero?");
  for (auto const& nodes : mesh.nodes)
    VALIDATE(std::ranges::all_of(nodes, [](auto const& x) { return x.allFinite(); }),
             where + ": a node has no finite position (it is nowhere). Is the file damaged?");
  std::set<std::string> const names(mesh.surfaces.begin(), mesh.surfaces.end());
  VALIDATE(names.size() == mesh.surfaces.size(),
           where + ": two surfaces have the same name (loads would not know which). Rename one?");
}

// Neighbours along x are compared: a mesh has few vertices within a hair of one plane.
void refuse_coinciding_vertices(HexMesh const& mesh, std::string const& where) {
  std::set<unsigned> used;
  for (auto const& cell : mesh.cells)
    used.insert(cell.begin(), cell.end());
  std::vector<unsigned> by_x(used.begin(), used.end());
  std::ranges::sort(by_x, {}, [&](unsigned v) { return mesh.vertices[v].x(); });
  double size = 0.0;
  for (unsigned const v : by_x)
    size = std::max(size, (mesh.vertices[v] - mesh.vertices[by_x[0]]).norm());
  double const hair = 1e-9 * size;
  for (std::size_t i = 0; i < by_x.size(); ++i)
    for (std::size_t j = i + 1; j < by_x.size(); ++j) {
      Eigen::Vector3d const apart = mesh.vertices[by_x[j]] - mesh.vertices[by_x[i]];
      if (apart.x() > hair)
        break;
      VALIDATE(apart.norm() > hair,
               where + ": vertices " + std::to_string(by_x[i]) + " and " + std::to_string(by_x[j]) +
                   " coincide at " + place(mesh, by_x[i]) +
                   " (the body is torn there, not watertight). Merge duplicate nodes?");
    }
}

std::set<Corners> boundary_of(HexMesh const& mesh, std::string const& where) {
  std::map<Corners, int> n_cells;
  for (auto const& cell : mesh.cells)
    for (unsigned face = 0; face < 6; ++face)
      ++n_cells[sorted(face_of(cell, face))];
  std::set<Corners> boundary;
  for (auto const& [corners, n] : n_cells) {
    VALIDATE(n <= 2, where + ": a face at " + place(mesh, corners[0]) + " belongs to " +
                         std::to_string(n) +
                         " cells (two bodies overlap, or a cell is there twice). Was the mesh "
                         "written twice?");
    if (n == 1)
      boundary.insert(corners);
  }
  return boundary;
}

void refuse_open_boundary(HexMesh const& mesh, std::set<Corners> const& boundary,
                          std::string const& where) {
  std::map<std::pair<unsigned, unsigned>, int> n_faces;
  for (auto const& cell : mesh.cells)
    for (unsigned face = 0; face < 6; ++face) {
      Corners const corners = face_of(cell, face);
      if (!boundary.contains(sorted(corners)))
        continue;
      for (auto const& [a, b] : {std::pair{0, 1}, {1, 3}, {3, 2}, {2, 0}})
        ++n_faces[std::minmax(corners[a], corners[b])];
    }
  for (auto const& [edge, n] : n_faces)
    VALIDATE(n == 2, where + ": the edge at " + place(mesh, edge.first) + " lies on " +
                         std::to_string(n) +
                         " boundary faces (the surface of a body has two at an edge). Do cells "
                         "touch in an edge only?");
}

void validate_surfaces(HexMesh const& mesh, std::set<Corners> const& boundary,
                       std::string const& where) {
  std::map<Corners, unsigned> surface_of;
  for (HexMesh::Quad const& quad : mesh.boundary) {
    VALIDATE(quad.surface < mesh.surfaces.size(),
             where + ": a face of surface " + std::to_string(quad.surface) + " of " +
                 std::to_string(mesh.surfaces.size()) + " (it has no name). Is a name missing?");
    auto const corners = sorted(quad.vertices);
    std::string const& name = mesh.surfaces[quad.surface];
    VALIDATE(boundary.contains(corners),
             where + ": surface '" + name +
                 "' has a face that is no face of the body's boundary "
                 "(nothing could touch it). Does the name stand on an inner face?");
    auto const [found, is_new] = surface_of.try_emplace(corners, quad.surface);
    VALIDATE(is_new, where + ": a face is part of '" + mesh.surfaces[found->second] + "' and '" +
                         name + "' (each has one surface). Are they named twice?");
  }
  for (Corners const& corners : boundary)
    VALIDATE(surface_of.contains(corners),
             where + ": the boundary face at " + place(mesh, corners[0]) +
                 " has no surface (supports and loads act on named ones). Name it, too?");
}
} // namespace

void validate(HexMesh const& mesh, std::string const& where) {
  validate_counts(mesh, where);
  refuse_coinciding_vertices(mesh, where);
  std::set<Corners> const boundary = boundary_of(mesh, where);
  refuse_open_boundary(mesh, boundary, where);
  validate_surfaces(mesh, boundary, where);
}

} // namespace continuum
