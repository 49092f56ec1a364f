#include "continuum/tool/tet_subdivision.hpp"

#include "continuum/tool/curved_skin.hpp"

#include <Eigen/Geometry>

#include <algorithm>

namespace continuum {

TetSubdivision::TetSubdivision(std::vector<Eigen::Vector3d> points) {
  mesh_.vertices = std::move(points);
}

unsigned TetSubdivision::middle(std::vector<unsigned> corners) {
  std::ranges::sort(corners);
  auto const [found, is_new] = middles_.try_emplace(corners, mesh_.vertices.size());
  if (is_new) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (unsigned const corner : corners)
      sum += mesh_.vertices[corner];
    mesh_.vertices.push_back(sum / corners.size());
  }
  return found->second;
}

void TetSubdivision::add_tetrahedron(std::array<unsigned, 4> corners) {
  auto const side = [&](int v) -> Eigen::Vector3d {
    return mesh_.vertices[corners[v]] - mesh_.vertices[corners[0]];
  };
  if (side(1).cross(side(2)).dot(side(3)) < 0.0)
    std::swap(corners[2], corners[3]);
  // Even permutations: the three others are right-handed seen from each corner.
  for (auto const& [o, x, y, z] :
       {std::array{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}}) {
    unsigned const p = corners[o], a = corners[x], b = corners[y], c = corners[z];
    mesh_.cells.push_back({p, middle({p, a}), middle({p, b}), middle({p, a, b}), middle({p, c}),
                           middle({p, a, c}), middle({p, b, c}), middle({p, a, b, c})});
  }
}

void TetSubdivision::add_triangle(std::array<unsigned, 3> const& corners, unsigned surface) {
  for (int v = 0; v < 3; ++v) {
    unsigned const p = corners[v], a = corners[(v + 1) % 3], b = corners[(v + 2) % 3];
    mesh_.boundary.push_back({{p, middle({p, a}), middle({p, b}), middle({p, a, b})}, surface});
  }
}

HexMesh TetSubdivision::take(std::vector<std::string> surfaces) {
  mesh_.surfaces = std::move(surfaces);
  mesh_.regions.assign(mesh_.cells.size(), 0);
  straighten(mesh_);
  return std::move(mesh_);
}

} // namespace continuum
