#pragma once

#include "dem/vec3.hpp"

#include <span>
#include <vector>

namespace dem {

/// The cylinder that holds grains: axis z, from z = 0 to `height`.
struct FillVolume {
  double radius;               ///< [m], of the bore
  double height;               ///< [m], between the punch faces
  double wall_clearance = 0.0; ///< [m], kept free at the bore (sagitta of a faceted one), >= 0
};

/// Gap that every pair of grains and every grain and wall keep at least, over the sum of their
/// radii: a tenth of a picometre, so that no way of rounding a distance finds an overlap.
inline constexpr double packing_clearance = 1e-9;

/// Moves a centre to the nearest place where its grain is inside the volume.
Vec3 clamp_inside(Vec3 const& centre, double radius, FillVolume const& volume);

struct Relaxation {
  bool is_free; ///< no pair overlaps
  int n_sweeps;
  double largest_overlap; ///< [1], of the sum of the radii, of the last sweep
};

/// Pushes overlapping grains apart, pair by pair in a fixed order, until none overlap or
/// `max_sweeps` are done: the pair moves along its line of centres to a gap of 1 per mille, the
/// lighter grain by more (shares by volume); grains stay inside the volume. Below jamming (random
/// spheres: 64 % solid) this converges geometrically.
/// @param centres  [m], n_grains, inside the volume; moved
/// @param radii    [m], largest first
Relaxation relax_overlaps(std::vector<Vec3>& centres, std::span<double const> radii,
                          FillVolume const& volume, int max_sweeps);

} // namespace dem
