#pragma once

#include "dem/surface/box_tree.hpp"
#include "dem/surface/closest_point.hpp"
#include "dem/surface/smooth_patches.hpp"
#include "dem/surface/smooth_surface.hpp"
#include "dem/surface/surface_edges.hpp"

#include <optional>
#include <vector>

namespace dem {

/// The nearest point of one patch to a grain's centre, before it is decided whether it counts.
struct PatchHit {
  std::uint32_t patch;
  std::uint32_t triangle;
  ClosestPoint nearest;
  bool on_rim; ///< on a sharp or open edge, or on a vertex of one
};

/// The immutable search structure behind a SmoothSurface.
struct SmoothSurface::Search {
  Search(TriangleSurface triangle_surface, double smooth_angle, Recognition recognition);

  /// The nearest point of a patch's curved triangles, if one lies within `reach`.
  std::optional<PatchHit> nearest(std::uint32_t patch, Vec3 const& centre, double reach) const;

  /// Whether a rim point is a nearest point of the whole surface in its neighbourhood: then no
  /// adjoining patch comes nearer to `centre` next to it.
  bool is_local_minimum(PatchHit const& hit, Vec3 const& centre) const;

  SurfacePoint face_point(PatchHit const& hit, Vec3 const& centre) const;
  SurfacePoint rim_point(PatchHit const& hit, Vec3 const& centre) const;

  /// Whether the way from a face, through the body behind it, to `centre` comes out of the body
  /// before.
  bool is_hidden(SurfacePoint const& contact, Vec3 const& centre) const;

  TriangleSurface surface;
  SurfaceEdges edges;
  SmoothPatches smooth;
  std::vector<std::array<Vec3, 3>> normals; // of the smooth surface, per triangle and corner
  std::vector<CurvedTriangle> curved;
  std::vector<bool> vertex_on_rim;
  BoxTree patch_tree;                           // of whole patches
  std::vector<BoxTree> triangle_trees;          // per patch, rows of smooth.triangles[patch]
  std::vector<std::vector<std::uint32_t>> rims; // per patch, its sharp and open edges
  std::vector<BoxTree> rim_trees;               // per patch, rows of rims[patch]

private:
  void plant_trees();
  bool lies_on_rim(std::uint32_t triangle, ClosestPoint const& nearest) const;
  bool is_inside(PatchHit const& hit, Vec3 const& outwards_arm) const;
};

} // namespace dem
