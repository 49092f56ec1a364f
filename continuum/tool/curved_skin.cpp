#include "continuum/tool/curved_skin.hpp"

#include "continuum/tool/raise_cell.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>

namespace continuum {

namespace {
// A node by the vertices that it stands in the middle of, ascending: one, two or four.
using NodeName = std::vector<unsigned>;

constexpr int n_sweeps = 50; // a move reaches some seven cells deep

Eigen::Vector3d onto(CylinderShape const& cylinder, Eigen::Vector3d const& x) {
  Eigen::Vector3d const axis = cylinder.axis.normalized();
  Eigen::Vector3d const along = axis * axis.dot(x - cylinder.point);
  Eigen::Vector3d const out = x - cylinder.point - along;
  return cylinder.point + along + cylinder.radius * out.normalized();
}

// The vertices of a cell or face, counted in two or three directions, around the node that stands
// at `place` / 2 in each.
template <std::size_t n>
NodeName name_of(std::array<unsigned, n> const& vertices, std::array<unsigned, 3> const& place) {
  NodeName name;
  for (unsigned v = 0; v < n; ++v) {
    bool is_around = true;
    for (unsigned c = 0; c < 3; ++c) {
      unsigned const end = v >> c & 1u;
      is_around = is_around && (place[c] == 1 || (n == 4 && c == 2) || place[c] == 2 * end);
    }
    if (is_around)
      name.push_back(vertices[v]);
  }
  std::ranges::sort(name);
  return name;
}

std::array<unsigned, 3> place_of(unsigned node) {
  return {node % 3, node / 3 % 3, node / 9};
}

// The vertices inside follow those of the boundary: each by the mean of its neighbours' moves, so
// that a flat cell beside a round surface is pushed along and not through.
void follow(HexMesh& mesh, std::vector<Eigen::Vector3d> const& from) {
  std::vector<bool> is_inside(mesh.vertices.size(), true);
  for (HexMesh::Quad const& quad : mesh.boundary)
    for (unsigned const v : quad.vertices)
      is_inside[v] = false;
  std::vector<std::vector<unsigned>> neighbours(mesh.vertices.size());
  for (auto const& cell : mesh.cells)
    for (unsigned v = 0; v < 8; ++v)
      for (unsigned const side : {1u, 2u, 4u})
        if (is_inside[cell[v]])
          neighbours[cell[v]].push_back(cell[v ^ side]);
  for (int sweep = 0; sweep < n_sweeps; ++sweep)
    for (std::size_t v = 0; v < neighbours.size(); ++v) {
      Eigen::Vector3d moved = Eigen::Vector3d::Zero();
      for (unsigned const w : neighbours[v])
        moved += mesh.vertices[w] - from[w];
      if (!neighbours[v].empty())
        mesh.vertices[v] = from[v] + moved / static_cast<double>(neighbours[v].size());
    }
}

// Where the nodes of round surfaces go. A name with one vertex moves that vertex.
std::map<NodeName, Eigen::Vector3d>
round_nodes(HexMesh& mesh, std::vector<std::optional<CylinderShape>> const& cylinders) {
  auto const from = mesh.vertices;
  for (HexMesh::Quad const& quad : mesh.boundary)
    if (auto const& cylinder = cylinders[quad.surface])
      for (unsigned const v : quad.vertices)
        mesh.vertices[v] = onto(*cylinder, mesh.vertices[v]);
  follow(mesh, from);
  std::map<NodeName, Eigen::Vector3d> moved;
  for (HexMesh::Quad const& quad : mesh.boundary)
    if (auto const& cylinder = cylinders[quad.surface])
      for (unsigned node = 0; node < 9; ++node) {
        NodeName const name = name_of(quad.vertices, place_of(node));
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        for (unsigned const v : name)
          middle += mesh.vertices[v] / static_cast<double>(name.size());
        moved[name] = onto(*cylinder, middle);
      }
  return moved;
}

void place_nodes(HexMesh& mesh, std::map<NodeName, Eigen::Vector3d> const& moved) {
  mesh.nodes.assign(mesh.cells.size(), {});
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    std::array<bool, 27> is_known{};
    for (unsigned node = 0; node < 27; ++node) {
      NodeName const name = name_of(mesh.cells[c], place_of(node));
      auto const found = moved.find(name);
      is_known[node] = is_corner(node) || found != moved.end();
      if (is_known[node])
        mesh.nodes[c][node] = found != moved.end() ? found->second : mesh.vertices[name[0]];
    }
    raise_cell(mesh.nodes[c], is_known);
  }
}

} // namespace

void straighten(HexMesh& mesh) {
  place_nodes(mesh, {});
}

void curve_onto(HexMesh& mesh, std::vector<std::optional<CylinderShape>> const& cylinders) {
  auto const moved = round_nodes(mesh, cylinders);
  place_nodes(mesh, moved);
}

Triangles skin_of(HexMesh const& mesh) {
  std::map<NodeName, unsigned> numbers; // of the boundary's nodes, as vertices of the skin
  Triangles skin;
  for (HexMesh::Quad const& quad : mesh.boundary) {
    std::array<unsigned, 9> at{};
    for (unsigned node = 0; node < 9; ++node)
      at[node] =
          numbers.try_emplace(name_of(quad.vertices, place_of(node)), numbers.size()).first->second;
    for (unsigned const corner : {0u, 1u, 3u, 4u}) {
      skin.corners.push_back({at[corner], at[corner + 1], at[corner + 4]});
      skin.corners.push_back({at[corner], at[corner + 4], at[corner + 3]});
    }
  }
  skin.vertices.resize(numbers.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (unsigned node = 0; node < 27; ++node)
      if (auto const found = numbers.find(name_of(mesh.cells[c], place_of(node)));
          found != numbers.end())
        skin.vertices[found->second] = mesh.nodes[c][node];
  return skin;
}

} // namespace continuum
