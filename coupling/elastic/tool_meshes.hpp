#pragma once

#include "continuum/tool/tool_mesh.hpp"
#include "coupling/case.hpp"

#include <string>
#include <vector>

namespace coupling {

/// What an elastic tool is made of, before it is held.
struct ToolBody {
  continuum::ToolMesh mesh;
  std::vector<continuum::ElasticMaterial> materials; ///< one a region of the mesh
};

/// The case's die: from its dimensions, with a bonded ring as a second region, or from its mesh
/// file. A bore from a file must be the case's within 1 % about the z axis, begin at the lower
/// punch's face or below, z <= 0, and reach the fill height.
/// @throws dem::InvalidInput  naming the file: if it cannot be used or is another die
/// @throws continuum::InvalidInput  if the dimensions make no die
ToolBody make_die_body(Case const& setup);

/// The case's upper or lower punch, in its own frame: face at z = 0 as far as it is flat. One from
/// a file must fit the bore within 1 % and have its back on the far side of the face.
/// @throws  as make_die_body
ToolBody make_punch_body(Case const& setup, continuum::PunchPlace place);

} // namespace coupling
