#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace continuum {

/// A surface of triangles.
struct Triangles {
  std::vector<Eigen::Vector3d> vertices = {}; ///< [m]
  std::vector<std::array<std::uint32_t, 3>> corners = {};
};

/// The point of a triangle that is closest to x.
/// Source: Ericson, Real-Time Collision Detection (2005), section 5.1.5.
Eigen::Vector3d closest_point(std::array<Eigen::Vector3d, 3> const& triangle,
                              Eigen::Vector3d const& x);

/// Largest distance [m] from corners, middles of sides and middles of triangles of either surface
/// to the other: what two surfaces of straight triangles leave between them, up to points that lie
/// between those.
double largest_gap(Triangles const& one, Triangles const& other);

} // namespace continuum
