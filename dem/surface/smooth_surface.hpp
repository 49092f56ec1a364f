#pragma once

#include "dem/surface/fit_shape.hpp"
#include "dem/surface/triangle_surface.hpp"
#include "dem/vec3.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace dem {

/// Where a grain meets a smooth patch of a tool.
struct SurfacePoint {
  Vec3 point;             ///< [m], closest point of the patch
  Vec3 normal;            ///< unit, from the tool to the grain
  double distance;        ///< [m], of the grain's centre; negative behind the face
  std::uint32_t patch;    ///< the smooth patch; key of the contact's history
  std::uint32_t triangle; ///< the triangle that receives the force
};

/// [rad], between normals; below it two triangles are one smooth surface.
inline constexpr double default_smooth_angle = 0.35;

/// A tool's surface as grains feel it: one contact per grain and smooth patch, whatever the
/// triangulation. Triangles that meet at less than `smooth_angle` belong to one patch; a patch
/// whose vertices lie on a plane or a cylinder is that plane or cylinder, so grains follow the true
/// bore and not its chords; other curved patches are followed by quadratic interpolation of their
/// normals. A sharp edge counts once, and only where no adjoining face is nearer; behind the faces
/// of a body only the nearest one pushes, and none through the body.
class SmoothSurface {
public:
  /// @throws InvalidInput if a triangle is degenerate, an edge belongs to three triangles, or two
  /// neighbours disagree about the outside
  explicit SmoothSurface(TriangleSurface surface, double smooth_angle = default_smooth_angle,
                         Recognition recognition = Recognition::planes_and_cylinders);
  SmoothSurface(SmoothSurface&&) noexcept;
  SmoothSurface& operator=(SmoothSurface&&) noexcept;
  SmoothSurface(SmoothSurface const&); // shares the immutable search structure
  SmoothSurface& operator=(SmoothSurface const&);
  ~SmoothSurface();

  TriangleSurface const& triangles() const;
  std::span<SmoothPatch const> patches() const;

  /// Every patch within `reach` [m] of `centre` (tool's own frame), at most one point a patch,
  /// sorted by patch. Appends to `out`.
  void find(Vec3 const& centre, double reach, std::vector<SurfacePoint>& out) const;

  /// The same point as `find` on one plane or cylinder patch, when it is known that the closest
  /// point is inside it. Nothing is searched, so `triangle` is the patch's first: ask `triangle_at`
  /// where it matters.
  SurfacePoint on_patch(std::uint32_t patch, Vec3 const& centre) const;

  /// Distance [m] of a point of a patch from the patch's rim: inside it `on_patch` needs no search.
  /// Infinite on a patch without a rim.
  double distance_to_rim(std::uint32_t patch, Vec3 const& point) const;

  /// The triangle of `patch` nearest to `point`: where forces are tallied.
  std::uint32_t triangle_at(std::uint32_t patch, Vec3 const& point) const;

  struct Search;

private:
  std::shared_ptr<Search const> search_;
};

} // namespace dem
