#pragma once

#include "dem/surface/closest_point.hpp"
#include "dem/surface/fit_shape.hpp"
#include "dem/surface/surface_edges.hpp"
#include "dem/surface/triangle_surface.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace dem {

/// The smooth patches of a surface, numbered by their lowest triangle.
struct SmoothPatches {
  std::vector<SmoothPatch> patches;
  std::vector<std::uint32_t> of_triangle;            ///< patch of each triangle
  std::vector<std::vector<std::uint32_t>> triangles; ///< of each patch, ascending
  std::vector<bool> edge_is_rim;                     ///< sharp or open
};

/// Joins triangles whose normals differ by less than `smooth_angle` [rad] across their common edge,
/// and recognises the planes and cylinders among the patches.
SmoothPatches find_smooth_patches(TriangleSurface const& surface, SurfaceEdges const& edges,
                                  double smooth_angle, Recognition recognition);

/// The normal of the smooth surface at the corners of each triangle: exact on planes and cylinders,
/// else the mean over the patch's triangles around the vertex with Max's weights, which are exact
/// on a sphere however its triangles are cut, and on a cylinder of uneven facets to second order:
///   n ~ sum (e1 x e2) / (|e1|^2 |e2|^2)
/// Source: Max, J. Graphics Tools 4(2) (1999) 1.
std::vector<std::array<Vec3, 3>> corner_normals(TriangleSurface const& surface,
                                                SurfaceEdges const& edges,
                                                SmoothPatches const& patches);

/// The triangles with sides that bulge as the corner normals ask: the middle of a side is that of
/// the circular arc through both ends that is square to the mean normal. A side between two patches
/// lies on both (a rim of a bore in a plane is an arc in that plane).
std::vector<CurvedTriangle> curve_sides(TriangleSurface const& surface, SurfaceEdges const& edges,
                                        std::vector<std::array<Vec3, 3>> const& normals);

} // namespace dem
