#pragma once

#include "dem/surface/triangle_surface.hpp"
#include "dem/vec3.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace dem {

/// Where a grain meets a smooth patch of a tool.
struct SurfacePoint {
  Vec3 point;              ///< [m], closest point of the patch
  Vec3 normal;             ///< unit, from the tool to the grain
  double distance;         ///< [m], of the grain's centre; negative behind the face
  std::uint32_t patch;     ///< the smooth patch; key of the contact's history
  std::uint32_t triangle;  ///< the triangle that receives the force
};

enum class PatchKind : std::uint8_t { plane, cylinder, curved };

/// A maximal set of triangles joined across smooth edges, and the exact surface they tessellate where it was
/// recognised.
struct SmoothPatch {
  PatchKind kind;
  Vec3 origin;      ///< [m], a point of the plane, or of the cylinder's axis
  Vec3 direction;   ///< unit, normal of the plane (outwards), or axis of the cylinder
  double radius;    ///< [m], of the cylinder; 0 for others
  double side;      ///< cylinder only: +1 normals point away from the axis (a shaft), -1 towards it (a bore)
};

/// A tool's surface as grains feel it: one contact per grain and smooth patch, whatever the triangulation.
/// Triangles that meet at less than `smooth_angle` belong to one patch; a patch whose vertices lie on a plane or a
/// cylinder is that plane or cylinder, so grains follow the true bore and not its chords; other curved patches are
/// followed by quadratic interpolation of their normals. A sharp edge counts once, and only where no adjoining
/// face is nearer.
class SmoothSurface {
public:
  explicit SmoothSurface(TriangleSurface surface, double smooth_angle = 0.35);
  SmoothSurface(SmoothSurface&&) noexcept;
  SmoothSurface& operator=(SmoothSurface&&) noexcept;
  SmoothSurface(SmoothSurface const&);             // shares the immutable search structure
  SmoothSurface& operator=(SmoothSurface const&);
  ~SmoothSurface();

  TriangleSurface const& triangles() const;
  std::span<SmoothPatch const> patches() const;

  /// Every patch within `reach` [m] of `centre` (tool's own frame), at most one point a patch, sorted by patch.
  /// Appends to `out`.
  void find(Vec3 const& centre, double reach, std::vector<SurfacePoint>& out) const;

  /// The same point as `find` on one plane or cylinder patch, when it is known that the closest point is inside it.
  SurfacePoint on_patch(std::uint32_t patch, Vec3 const& centre) const;

  /// Distance [m] of a point of a patch from the patch's rim: inside it `on_patch` needs no search.
  double distance_to_rim(std::uint32_t patch, Vec3 const& point) const;

  /// The triangle of `patch` nearest to `point`: where forces are tallied.
  std::uint32_t triangle_at(std::uint32_t patch, Vec3 const& point) const;

private:
  struct Search;
  std::shared_ptr<Search const> search_;
};

}  // namespace dem
