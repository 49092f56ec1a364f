#pragma once

#include <Eigen/Core>

#include <cstddef>

/// What the sources of ToolCoupling share.
namespace coupling {

/// Position of the tools in the press.
namespace tool_rows {
inline constexpr std::size_t die = 0, upper = 1, lower = 2;
} // namespace tool_rows

/// Work of nodal forces on nodal displacements, or the like.
inline double dot(Eigen::Matrix3Xd const& a, Eigen::Matrix3Xd const& b) {
  return (a.array() * b.array()).sum();
}

} // namespace coupling
