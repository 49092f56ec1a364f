#pragma once

#include "dem/spheres.hpp"

#include <span>
#include <vector>

namespace dem {

inline constexpr int n_shape_levels = 15;
inline constexpr double shape_top = 15e-3; ///< [m], the seed's levels span 0 to 15 mm

/// The shape of a compact as the seed sees it, 16 numbers [m]: its height (highest minus lowest
/// grain surface), then the average maximum radius at 15 levels. The paper leaves open what that
/// is; here
///  - the levels are 15 slabs of 1 mm from the floor to 15 mm; a grain belongs to every slab it
///  reaches into,
///    as the circle of its largest section there,
///  - in each of 36 equal sectors about the press axis the maximum radius is the farthest point of
///  any circle from
///    the axis, 0 in an empty sector, and the level's number is the mean over the sectors.
/// Slabs and not cuts: a cut takes whatever part of the outermost grains it happens to meet.
/// @param floor  [m], z of the lower punch's face; grains whose centre is below it do not count
/// Source: Ramirez-Aragon et al., Metals 10 (2020), section 2.3.
std::vector<double> compact_shape(Spheres const& grains, double floor);

/// Kohonen's (Tanimoto's) similarity of two shapes:  sum ab / (sum aa + sum bb - sum ab).
/// 1 for equal shapes, and for nothing else; for shapes of non-negative numbers it lies in [0, 1].
/// 1 for two empty ones. Source: Kohonen, Self-Organization and Associative Memory (1989), 2.1.
double shape_similarity(std::span<double const> a, std::span<double const> b);

/// The seed's scale: 5 from 87.5 % similarity, 4 from 75 %, 3 from 62.5 %, 2 from 50 %, 1 below.
int shape_quality(double similarity);

} // namespace dem
