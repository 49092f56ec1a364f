#pragma once

#include "dem/contact/contact_block.hpp"
#include "dem/surface/tool.hpp"

#include <vector>

namespace dem {

/// Where a grain meets a listed patch of a tool, now.
struct WallMeeting {
  double distance; ///< [m], of the grain's centre from the surface; negative behind it
  Vec3 normal;     ///< from the tool to the grain
  Vec3 point;      ///< [m], in space
  Vec3 velocity;   ///< [m/s], of the tool there
};

/// @param yield   what the contact with a deformable tool follows; null at a rigid one
/// @param centre  of the grain [m]
/// @param found   scratch
inline WallMeeting meet_wall(Tool const& tool, WallContact const& wall, WallYield const* yield,
                             double window_time, Vec3 const& centre, double radius,
                             std::vector<SurfacePoint>& found) {
  Vec3 shift = tool.displacement, velocity = tool.velocity;
  if (yield) {
    auto const& [displacement, speed] = yield->motion;
    shift += displacement + window_time * speed;
    velocity += speed;
  }
  Vec3 const own = centre - shift;
  // Nothing there: as far as a partner that does not touch.
  WallMeeting meeting{
      .distance = 2.0 * radius, .normal = Vec3::UnitZ(), .point = own, .velocity = velocity};
  auto const meet = [&](SurfacePoint const& at) {
    meeting.distance = at.distance, meeting.normal = at.normal, meeting.point = at.point;
  };
  if (tool.present && wall.inside_rim) {
    meet(tool.surface.on_patch(wall.patch, own));
  } else if (tool.present) {
    found.clear();
    tool.surface.find(own, 1.2 * radius, found);
    for (SurfacePoint const& at : found)
      if (at.patch == wall.patch)
        meet(at);
  }
  meeting.point += shift;
  return meeting;
}

} // namespace dem
