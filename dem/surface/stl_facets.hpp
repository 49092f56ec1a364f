#pragma once

#include "dem/vec3.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dem {

/// The three corners of one triangle as an STL file states them, in its own unit.
using StlFacet = std::array<Vec3, 3>;

/// Whether bytes are a binary STL: a length of 84 + 50 n with n at byte 80 settles it; else a
/// control character in the first kilobyte does, so that a truncated binary file is not mistaken
/// for text.
bool is_binary_stl(std::span<std::byte const> bytes);

/// @throws InvalidInput if the length does not match the count, or a coordinate is not finite
std::vector<StlFacet> parse_binary_stl(std::span<std::byte const> bytes, std::string const& name);

/// @throws InvalidInput with the line of the first word that does not fit the grammar
///   { solid ... { facet normal x y z  outer loop  3 { vertex x y z }  endloop  endfacet } endsolid
///   ... }
std::vector<StlFacet> parse_ascii_stl(std::string_view text, std::string const& name);

} // namespace dem
