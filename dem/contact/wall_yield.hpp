#pragma once

#include "dem/contact/contact_block.hpp"
#include "dem/surface/tool.hpp"

#include <algorithm>
#include <span>

namespace dem {

inline bool any_deforms(std::span<Tool const> tools) {
  return std::ranges::any_of(tools, [](Tool const& tool) { return tool.deformation != nullptr; });
}

/// What a contact at a point of the undeformed surface (tool's own frame) follows from now on.
inline WallYield yield_at(Tool const& tool, std::uint32_t patch, Vec3 const& point) {
  if (!tool.deformation)
    return {};
  SurfacePlace const place = tool.deformation->locate(patch, point);
  return {.place = place, .motion = tool.deformation->at(place)};
}

} // namespace dem
