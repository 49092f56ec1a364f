#pragma once

#include "continuum/tool/mesh_files.hpp"
#include "continuum/tool/tool_shape.hpp"
#include "coupling/case.hpp"
#include "dem/surface/smooth_surface.hpp"

#include <string>
#include <vector>

namespace coupling {

/// A tool of the press that a STL file brings, where grains touch it.
struct StlTool {
  dem::SmoothSurface surface;     ///< in the tool's own frame
  std::vector<std::string> names; ///< of each patch: see below
  double height;                  ///< [m], of the own frame's z = 0 in the file

  /// The recognised planes and cylinders under their names, in the file's frame [m]; what a body
  /// made from the file is named by.
  std::vector<continuum::NamedShape> shapes() const;
};

/// The case's die. Patches: bore, the cylinder about the press axis; bottom, the lowest plane; all
/// others each a name of its own.
/// @throws dem::InvalidInput  if the file is no die of the case's bore that reaches down to the
/// lower punch
StlTool read_stl_die(Case const& setup);

/// The case's upper or lower punch, shifted so that its powder side is at z = 0 of its own frame.
/// Patches: back, the plane at the other end; side, the widest cylinder; face, all others.
/// @throws dem::InvalidInput  if the file is no punch of the case's bore
StlTool read_stl_punch(Case const& setup, continuum::PunchPlace place);

/// The same surface elsewhere on the press axis; patches keep their order.
dem::SmoothSurface moved_along_axis(dem::SmoothSurface const& surface, double z);

} // namespace coupling
