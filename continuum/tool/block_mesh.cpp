#include "continuum/expect.hpp"
#include "continuum/tool/hex_mesh.hpp"

#include <algorithm>

namespace continuum {

namespace {
void validate(GridLines const& lines) {
  for (std::vector<double> const& line : lines)
    VALIDATE(line.size() >= 2 &&
                 std::ranges::adjacent_find(line, std::greater_equal()) == line.end(),
             "block: " + std::to_string(line.size()) +
                 " grid lines in one direction, or not ascending (cells lie between lines). Give "
                 "two or more, ascending?");
}
} // namespace

HexMesh mesh_block(GridLines const& lines, Placement const& place) {
  validate(lines);
  std::array<unsigned, 3> const n = {static_cast<unsigned>(lines[0].size() - 1),
                                     static_cast<unsigned>(lines[1].size() - 1),
                                     static_cast<unsigned>(lines[2].size() - 1)};
  auto const at = [&](unsigned i, unsigned j, unsigned k) {
    return (k * (n[1] + 1) + j) * (n[0] + 1) + i;
  };
  // Counted in half cells.
  auto const position = [&](unsigned i, unsigned j, unsigned k) {
    std::array<unsigned, 3> const twice = {i, j, k};
    Eigen::Vector3d grid;
    for (int c = 0; c < 3; ++c)
      grid[c] = 0.5 * (lines[c][twice[c] / 2] + lines[c][(twice[c] + 1) / 2]);
    return place(grid);
  };

  HexMesh mesh{.surfaces = {"left", "right", "front", "back", "bottom", "top"}};
  for (unsigned k = 0; k <= n[2]; ++k)
    for (unsigned j = 0; j <= n[1]; ++j)
      for (unsigned i = 0; i <= n[0]; ++i)
        mesh.vertices.push_back(position(2 * i, 2 * j, 2 * k));
  for (unsigned k = 0; k < n[2]; ++k)
    for (unsigned j = 0; j < n[1]; ++j)
      for (unsigned i = 0; i < n[0]; ++i) {
        std::array<unsigned, 8> cell;
        for (unsigned v = 0; v < 8; ++v)
          cell[v] = at(i + v % 2, j + v / 2 % 2, k + v / 4);
        mesh.cells.push_back(cell);
        mesh.nodes.push_back(cell_nodes([&](unsigned a, unsigned b, unsigned c) {
          return position(2 * i + a, 2 * j + b, 2 * k + c);
        }));
        for (unsigned face = 0; face < 6; ++face) {
          unsigned const c = face / 2, end = face % 2;
          if (std::array{i, j, k}[c] != end * (n[c] - 1))
            continue;
          std::array<unsigned, 4> quad;
          std::ranges::copy_if(cell, quad.begin(),
                               [&, v = 0u](unsigned) mutable { return (v++ >> c) % 2 == end; });
          mesh.boundary.push_back({quad, face});
        }
      }
  mesh.regions.assign(mesh.cells.size(), 0);
  return mesh;
}

} // namespace continuum
