#pragma once

#include "dem/surface/smooth_surface.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace dem {

/// A rigid tool: a surface in its own frame, moved by a translation.
struct Tool {
  std::string name;                 ///< "die", "upper_punch", "lower_punch"
  SmoothSurface surface;            ///< in the tool's own frame
  std::uint8_t material = 0;        ///< row of the MaterialTable
  bool present = true;              ///< a removed tool touches nothing
  Vec3 displacement = Vec3::Zero(); ///< [m], from the tool's own frame to space
  Vec3 velocity = Vec3::Zero();     ///< [m/s]
  Vec3 force = Vec3::Zero();        ///< [N], by the grains on the tool, of the last step
  double radial_force = 0.0; ///< [N], sum of outward normal components away from the press axis
  double work = 0.0;         ///< [J], done by the tool on the grains since the start
};

} // namespace dem
