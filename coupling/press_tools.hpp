#pragma once

#include "coupling/case.hpp"
#include "coupling/press_programme.hpp"
#include "dem/surface/tool.hpp"

#include <vector>

namespace coupling {

/// The tools of a press where they stand at the start, displacements zero, in the order die, upper
/// punch, lower punch.
///  - read from STL, or generated from dimensions at the chordal tolerance;
///  - a punch from a file is shifted along z until its face is at z = 0 (lower) or at the fill
///  height (upper);
///  - analytic walls are the same shapes so far beyond the powder that no grain meets a rim:
///  recognised as what they
///    tessellate, they are an exact cylinder and exact planes.
/// @param material  row of the tools' material
/// @throws dem::InvalidInput if a file cannot be used or its size contradicts the case
std::vector<dem::Tool> make_tools(Case const& setup, std::uint8_t material);

/// Share of the compliance of a contact with a tool that the contact law gives to the tool [1],
///   (1 - nu_t^2)/E_t / ((1 - nu_t^2)/E_t + (1 - nu_g^2)/E_g),
/// the largest over the powder's components. The body of a deformable tool is indented as well, so
/// this part of the contact counts twice.
double tool_share(Case const& setup);

/// Where the punch faces are at the start.
PunchFaces starting_faces(Case const& setup);

} // namespace coupling
