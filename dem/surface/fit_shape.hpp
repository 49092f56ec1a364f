#pragma once

#include "dem/surface/triangle_surface.hpp"

#include <cstdint>
#include <optional>
#include <span>

namespace dem {

/// Which exact shapes a patch may become.
enum class Recognition : std::uint8_t {
  planes_and_cylinders,
  nothing ///< every patch is followed by its corner normals: to measure what that alone reaches
};

enum class PatchKind : std::uint8_t { plane, cylinder, curved };

/// A maximal set of triangles joined across smooth edges, and the exact surface they tessellate
/// where it was recognised.
struct SmoothPatch {
  PatchKind kind = PatchKind::curved;
  Vec3 origin = Vec3::Zero();    ///< [m], a point of the plane, or of the cylinder's axis
  Vec3 direction = Vec3::Zero(); ///< unit, normal of the plane (outwards), or axis of the cylinder
  double radius = 0.0;           ///< [m], of the cylinder; 0 for others
  double side =
      0.0; ///< cylinder only: +1 normals point away from the axis (a shaft), -1 towards it (a bore)
};

/// How far a vertex may stand off the recognised plane or cylinder, as a fraction of the patch's
/// extent: wide enough for the six digits of an ASCII file and for the parabolas of a second-order
/// mesh (0.1 um on the seed's bore), far below any overlap that matters.
inline constexpr double recognition_tolerance = 1e-5;

/// The plane through all corners of `triangles`: area-weighted normal through the area-weighted
/// centroid.
/// @returns nothing if a corner stands off it by more than the tolerance
std::optional<SmoothPatch> fit_plane(TriangleSurface const& surface,
                                     std::span<std::uint32_t const> triangles);

/// The cylinder through all corners of `triangles`, by least squares (Gauss and Newton) on the
/// corners' distances from it, started from the direction that the facet normals avoid.
/// @param largest_turn  [rad], widest angle that a triangle may span about the axis: a wider one is
/// a flat
/// @returns nothing if a corner stands off it by more than the tolerance, or if there are fewer
/// than five
///          generators (any flat with two equal chamfers lies on four)
std::optional<SmoothPatch> fit_cylinder(TriangleSurface const& surface,
                                        std::span<std::uint32_t const> triangles,
                                        double largest_turn);

} // namespace dem
