#pragma once

#include "coupling/elastic/yielding_tool.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace coupling {

/// The whole surface of a tool with the stress that loads cause there.
struct StressedSurface {
  std::vector<dem::Vec3> vertices;                     ///< [m], in the tool's own frame
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< counter-clockwise seen from outside
  std::vector<double> von_mises;                       ///< [Pa], of each vertex
};

/// Every second-order face as eight triangles between its nine nodes, with the stress at the nodes
/// (mean over the cells of a named surface that share one, so that edges keep a value a side).
StressedSurface stressed_surface(YieldingTool const& tool, Eigen::Matrix3Xd const& loads);

} // namespace coupling
