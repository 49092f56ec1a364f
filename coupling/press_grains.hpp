#pragma once

#include "coupling/case.hpp"
#include "dem/material.hpp"
#include "dem/spheres.hpp"

namespace coupling {

/// Materials of a case: one row per component of the powder, then the tools'.
/// @param friction  share of the case's static friction that contacts have [1]
dem::MaterialTable make_materials(Case const& setup, double friction = 1.0);

/// Row of the tools' material.
std::uint8_t tool_material(Case const& setup);

/// The grains at the start, from the case's seed, a packing file or an earlier run's state.
/// @throws dem::InvalidInput if they do not fit, or the file cannot be used
dem::Spheres fill_die(Case const& setup);

} // namespace coupling
