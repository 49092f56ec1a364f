#pragma once

#include "dem/contact/contact_block.hpp"
#include "dem/vec3.hpp"

#include <cstdint>
#include <vector>

namespace dem {

/// The contact engine's state as plain arrays. The neighbour lists are functions of the positions
/// and skins at their last builds, so these are kept and the lists are built again; springs follow
/// in list order, block by block.
struct ContactState {
  std::vector<Vec3> outer_position, inner_position; ///< [m], n_grains, at the last builds
  std::vector<double> outer_skin, inner_skin;       ///< [m], n_grains
  std::vector<Vec3> outer_tool, inner_tool; ///< [m], displacement of each tool at the last builds
  std::vector<double> outer_tool_skin, inner_tool_skin;             ///< [m], n_tools
  std::vector<double> outer_tool_yielded, inner_tool_yielded;       ///< [m], n_tools, as in ListAge
  std::vector<double> outer_tool_extent, inner_tool_extent;         ///< [m], n_tools
  std::vector<std::uint8_t> outer_tool_present, inner_tool_present; ///< n_tools, at the last builds
  std::vector<Vec3> spring;                                         ///< [m], n_contacts
  std::vector<double> normal_memory;                                ///< n_contacts
  std::vector<WallYield> yields;     ///< n_contacts with tools if one is deformable, else none
  std::vector<WallImpulse> impulses; ///< of this window, of contacts of lists that are gone
  std::uint64_t outer_builds = 0, inner_builds = 0;
};

} // namespace dem
