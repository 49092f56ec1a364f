#pragma once

#include "dem/vec3.hpp"

#include <array>
#include <cstdint>

namespace dem {

/// In the order of preference where two are equally near.
enum class Feature : std::uint8_t { face, side, corner };

/// A triangle whose sides are parabolic arcs; side k joins corners k and k + 1. With barycentric
/// weights b
///   x(b) = sum_k b_k corner_k + 4 sum_k b_k b_(k+1) bulge_k,
/// so bulge_k is how far the middle of side k stands off its chord. All bulges zero: the flat
/// triangle.
struct CurvedTriangle {
  std::array<Vec3, 3> corners;                                             ///< [m]
  std::array<Vec3, 3> bulges = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}; ///< [m]
  bool is_flat = true;                                                     ///< all bulges are zero

  Vec3 at(Vec3 const& weights) const;

  /// dx/db_1 and dx/db_2 with b_0 = 1 - b_1 - b_2.
  std::array<Vec3, 2> tangents(Vec3 const& weights) const;
};

/// The point of a triangle that is nearest to another point, and where on the triangle it lies.
struct ClosestPoint {
  Vec3 point;      ///< [m]
  Vec3 weights;    ///< barycentric, each >= 0, sum 1
  double distance; ///< [m], >= 0
  Feature feature;
  std::uint8_t row; ///< which side or corner; 0 for the face
};

/// Distances that differ by less than this fraction are equal.
inline constexpr double equally_near = 1e-14;

/// Whether `one` is nearer than `other`. A corner and a point 1e-8 distances beside it on a side
/// are equally far in double precision; then the side is meant, because its nearest point was found
/// from directions, not from lengths.
bool is_nearer(ClosestPoint const& one, ClosestPoint const& other);

/// Exact on the flat triangle through the corners, by Voronoi regions.
/// Source: Ericson, Real-Time Collision Detection (2005), 5.1.5.
ClosestPoint closest_on_flat(std::array<Vec3, 3> const& corners, Vec3 const& centre);

/// On the arc  x(s) = a + s (b - a) + 4 s (1 - s) bulge,  s in [0, 1]:  Newton's method on |x(s) -
/// centre|^2.
/// @returns s
double closest_on_arc(Vec3 const& a, Vec3 const& b, Vec3 const& bulge, Vec3 const& centre);

/// On a curved triangle: Newton's method inside, the three arcs if the stationary point lies
/// outside. Holds while the bulges are small against the sides and `centre` is nearer than the
/// radius of curvature.
ClosestPoint closest_on_curved(CurvedTriangle const& triangle, Vec3 const& centre);

} // namespace dem
