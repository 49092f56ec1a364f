#pragma once

#include "dem/surface/triangle_surface.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace dem {

/// An edge of a triangle surface and the one or two triangles that it bounds.
struct SurfaceEdge {
  static constexpr std::uint32_t none = 0xffffffffu;
  std::array<std::uint32_t, 2> vertices;  ///< as the first triangle runs along it
  std::array<std::uint32_t, 2> triangles; ///< the second is `none` at an open edge
  std::array<std::uint8_t, 2>
      sides; ///< which side of each triangle; side k joins corners k and k + 1

  bool is_open() const { return triangles[1] == none; }
};

/// Who borders whom on a triangle surface.
/// @throws InvalidInput if an edge belongs to three triangles, or to two that run along it the same
/// way; the message starts with the surface's name and counts triangles from 1, as they stand in
/// the file.
class SurfaceEdges {
public:
  explicit SurfaceEdges(TriangleSurface const& surface);

  std::span<SurfaceEdge const> edges() const { return edges_; }
  std::size_t n_open() const;

  /// The three edges of a triangle, by side.
  std::array<std::uint32_t, 3> const& of_triangle(std::uint32_t triangle) const {
    return of_triangle_[triangle];
  }

  /// The triangles that meet at a vertex, in ascending order.
  std::span<std::uint32_t const> around(std::uint32_t vertex) const {
    return std::span(fans_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
  }

private:
  std::vector<SurfaceEdge> edges_;
  std::vector<std::array<std::uint32_t, 3>> of_triangle_;
  std::vector<std::uint32_t> first_; // of each vertex in fans_, and the end
  std::vector<std::uint32_t> fans_;
};

/// (b - a) x (c - a) of a triangle: twice its area, along its outward normal [m^2].
Vec3 area_vector(TriangleSurface const& surface, std::uint32_t triangle);

} // namespace dem
