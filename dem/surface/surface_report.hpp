#pragma once

#include "dem/surface/triangle_surface.hpp"

#include <cstddef>

namespace dem {

/// What a triangle surface is, for the log and for `presscheck check`.
struct SurfaceReport {
  std::size_t n_vertices = 0;
  std::size_t n_triangles = 0;
  std::size_t n_open_edges = 0; ///< edges of one triangle only
  bool closed = false;          ///< no open edge: the surface bounds a body
  double volume = 0.0;          ///< [m^3], enclosed; 0 unless closed
  double area = 0.0;            ///< [m^2]
  Vec3 low = Vec3::Zero();      ///< [m], corner of the bounding box
  Vec3 high = Vec3::Zero();     ///< [m], opposite corner

  double largest_extent() const { return (high - low).maxCoeff(); } ///< [m]
};

/// Smallest height that a triangle may have, as a fraction of the box's diagonal; below it its
/// normal is noise.
inline constexpr double smallest_triangle_height = 1e-7;

/// Measures a surface.   volume = 1/6 sum of a . (b x c)  over triangles (divergence theorem)
/// @throws InvalidInput if a triangle is degenerate, an edge belongs to three triangles, or two
/// neighbours disagree about the outside. Messages start with the surface's name and count
/// triangles from 1.
SurfaceReport inspect_surface(TriangleSurface const& surface);

} // namespace dem
