#pragma once

#include "dem/vec3.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace dem {

/// An indexed triangle surface. Corners run anticlockwise seen from outside the body, so normals
/// point out of the tool into the powder.
struct TriangleSurface {
  std::string name;
  std::vector<Vec3> vertices;                          ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< rows of `vertices`
};

} // namespace dem
