#pragma once

#include "dem/vec3.hpp"

#include <cstdint>

namespace dem {

/// A place on a tool's deformable surface, in the numbers of whoever deforms it.
struct SurfacePlace {
  static constexpr std::uint32_t rigid = 0xffffffffu; ///< `face` where nothing deforms
  std::uint32_t face = rigid;
  double xi = 0.0, eta = 0.0; ///< on the face, in [0, 1]
};

/// How a tool's surface yields beside its rigid motion: grains meet x_rigid(t) + u(x, t), where u
/// runs on a straight line from the beginning of the present window (World::window_time = 0) on.
/// Normals stay those of the undeformed surface: strains are small.
class ToolDeformation {
public:
  struct Motion {
    Vec3 displacement = Vec3::Zero(); ///< [m], at the beginning of the window
    Vec3 velocity = Vec3::Zero();     ///< [m/s]
  };

  virtual ~ToolDeformation() = default;

  /// The place of a point of a patch (tool's own frame, undeformed).
  virtual SurfacePlace locate(std::uint32_t patch, Vec3 const& point) const = 0;
  /// Zero at a rigid place.
  virtual Motion at(SurfacePlace const& place) const = 0;

  virtual double extent() const = 0; ///< [m], bound of |u| in this window
  virtual double speed() const = 0;  ///< [m/s], bound of |velocity|
};

/// Where grains press a deformable tool, and what they gave it [N s].
struct WallImpulse {
  std::uint32_t tool;
  SurfacePlace place;
  Vec3 impulse; ///< on the tool, in space
};

} // namespace dem
