#pragma once

#include "continuum/tool/surface_trace.hpp"

#include <string>

namespace coupling {

/// Grains roll over edges of less than 20 degrees from one surface to the next, but only the
/// pressed one yields: its rim must be sharper.
/// @param where      what the message calls the tool
/// @param triangles  of the boundary
/// @throws dem::InvalidInput  naming tool and surfaces
void refuse_smooth_rim(std::string const& where, std::string const& pressed,
                       continuum::SurfaceTrace const& boundary,
                       continuum::TraceTriangles const& triangles);

} // namespace coupling
