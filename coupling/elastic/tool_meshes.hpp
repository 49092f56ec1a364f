#pragma once

#include "continuum/tool/tool_mesh.hpp"
#include "coupling/case.hpp"
#include "coupling/stl_tools.hpp"
#include "dem/surface/triangle_surface.hpp"

#include <optional>
#include <vector>

namespace coupling {

/// What an elastic tool is made of, before it is held.
struct ToolBody {
  continuum::ToolMesh mesh;
  std::vector<continuum::ElasticMaterial> materials; ///< one a region of the mesh
  double height = 0.0;             ///< [m], of the own frame's z = 0 in the frame of the mesh
  std::optional<StlTool> stl = {}; ///< what grains touch instead of the mesh's own trace
};

/// The case's die: from its mesh file, else from Tooling's STL by gmsh, else from its dimensions,
/// with a bonded ring as a second region. A bore from a file must be the case's within 1 % about
/// the z axis, begin at the lower punch's face or below, z <= 0, and reach the fill height.
/// @throws dem::InvalidInput  naming the file: if it cannot be used or is another die
/// @throws continuum::InvalidInput  if the dimensions make no die
ToolBody make_die_body(Case const& setup);

/// The case's upper or lower punch, in its own frame: face at z = 0 as far as it is flat. One from
/// a file must fit the bore within 1 % and have its back on the far side of the face.
/// @throws  as make_die_body
ToolBody make_punch_body(Case const& setup, continuum::PunchPlace place);

/// A triangulated trace as what grains touch.
/// @param offset  [m], from the frame of the mesh
dem::TriangleSurface surface_of(continuum::TraceTriangles const& mesh, dem::Vec3 const& offset);

} // namespace coupling
