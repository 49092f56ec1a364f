#include "coupling/elastic/smooth_rim.hpp"

#include "dem/expect.hpp"
#include "dem/surface/smooth_surface.hpp"
#include "dem/vec3.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace coupling {

void refuse_smooth_rim(std::string const& where, std::string const& pressed,
                       continuum::SurfaceTrace const& boundary,
                       continuum::TraceTriangles const& triangles) {
  constexpr double smooth_angle = dem::default_smooth_angle;
  struct Side {
    Eigen::Vector3d normal;
    std::uint32_t surface;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Side> edges;
  for (std::size_t t = 0; t < triangles.triangles.size(); ++t) {
    auto const& corners = triangles.triangles[t];
    auto const at = [&](int i) { return triangles.vertices[corners[i % 3]]; };
    Side const here{(at(1) - at(0)).cross(at(2) - at(0)).normalized(),
                    boundary.faces[triangles.faces[t]].surface};
    for (int i = 0; i < 3; ++i) {
      auto const [edge, is_new] =
          edges.try_emplace(std::minmax(corners[i], corners[(i + 1) % 3]), here);
      Side const& there = edge->second;
      bool const is_rim = (boundary.surfaces[here.surface] == pressed) !=
                          (boundary.surfaces[there.surface] == pressed);
      if (is_new || !is_rim)
        continue;
      double const angle = std::acos(std::clamp(here.normal.dot(there.normal), -1.0, 1.0));
      VALIDATE(angle > smooth_angle,
               fmt::format("{}: the surfaces '{}' and '{}' meet at {:.3g} degrees (below {:.3g} "
                           "grains feel one surface, and only '{}' yields). Make the edge sharper, "
                           "or name both as '{}'?",
                           where, boundary.surfaces[here.surface], boundary.surfaces[there.surface],
                           angle * 180.0 / dem::pi, smooth_angle * 180.0 / dem::pi, pressed,
                           pressed));
    }
  }
}

} // namespace coupling
