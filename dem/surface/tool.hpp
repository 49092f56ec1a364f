#pragma once

#include "dem/surface/smooth_surface.hpp"
#include "dem/surface/tool_deformation.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace dem {

/// A tool: a surface in its own frame, moved by a translation and, unless it is rigid, deformed.
struct Tool {
  std::string name;                 ///< "die", "upper_punch", "lower_punch"
  SmoothSurface surface;            ///< in the tool's own frame
  std::uint8_t material = 0;        ///< row of the MaterialTable
  bool present = true;              ///< a removed tool touches nothing
  Vec3 displacement = Vec3::Zero(); ///< [m], from the tool's own frame to space
  Vec3 velocity = Vec3::Zero();     ///< [m/s]
  Vec3 force = Vec3::Zero();        ///< [N], by the grains on the tool, of the last step
  double radial_force = 0.0; ///< [N], sum of outward normal components away from the press axis
  double work = 0.0;         ///< [J], done on the grains by the rigid motion since the start

  std::shared_ptr<ToolDeformation const> deformation = nullptr; ///< null: rigid
  double yielded = 0.0;    ///< [m], bound of the way that any point of it has been deformed so far
  double yield_work = 0.0; ///< [J], done on the grains by the deformation since the start
};

} // namespace dem
