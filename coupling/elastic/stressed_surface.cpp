#include "coupling/elastic/stressed_surface.hpp"

namespace coupling {
namespace {

/// Nodes 3 j + i of a face at (i/2, j/2), with the normal along dx/dxi x dx/deta.
void append_face(std::array<std::uint32_t, 9> const& nodes, std::uint32_t first,
                 std::vector<std::array<std::uint32_t, 3>>& triangles) {
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 2; ++i) {
      auto const node = [&](std::size_t di, std::size_t dj) {
        return first + nodes[3 * (j + dj) + i + di];
      };
      triangles.push_back({node(0, 0), node(1, 0), node(1, 1)});
      triangles.push_back({node(0, 0), node(1, 1), node(0, 1)});
    }
}

} // namespace

StressedSurface stressed_surface(YieldingTool const& tool, Eigen::Matrix3Xd const& loads) {
  auto const all = tool.body.spread(tool.surface->trace(), loads);
  auto const displacement = tool.body.solve(all).displacement;
  StressedSurface whole;
  for (auto const& name : tool.body.mesh().surfaces()) {
    auto const& trace = tool.body.mesh().trace(name);
    auto const first = static_cast<std::uint32_t>(whole.vertices.size());
    for (auto const& point : tool.body.stress_on(name, displacement)) {
      whole.vertices.push_back(point.position + tool.offset);
      whole.von_mises.push_back(point.von_mises());
    }
    for (auto const& face : trace.faces)
      append_face(face.nodes, first, whole.triangles);
  }
  return whole;
}

} // namespace coupling
