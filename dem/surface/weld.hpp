#pragma once

#include "dem/surface/box_tree.hpp"
#include "dem/surface/triangle_surface.hpp"

#include <array>
#include <span>
#include <string>

namespace dem {

/// Joins corners that lie within `distance` [m] > 0 of each other into vertices, in the order of
/// their first use; the first one's coordinates stay.
/// @param box  of all corners; not wider than 1e18 distances
TriangleSurface weld(std::string name, std::span<std::array<Vec3, 3> const> facets, Box const& box,
                     double distance);

} // namespace dem
