#pragma once

#include "dem/surface/triangle_surface.hpp"

#include <cstdint>

namespace dem {

/// Facets of a circle whose chords stand off it by at most `chordal_tolerance` (both [m]):
///   n = ceil(pi / acos(1 - tolerance / R)),
/// and at least 24, so that neighbouring facets still join into one smooth patch. 22.05 mm at 0.01
/// mm: 74.
std::uint32_t n_facets(double diameter, double chordal_tolerance);

/// A die: a closed ring about the z axis with its bottom at z = 0. The vertices of the bore stand
/// on its circle. Dimensions [m], all > 0.  @throws InvalidInput if one is not
TriangleSurface make_die(double bore_diameter, double height, double wall_thickness,
                         double chordal_tolerance);

enum class PunchFace : std::uint8_t {
  up,  ///< a lower punch: its body reaches from 0 down to -length
  down ///< an upper punch: its body reaches from 0 up to +length
};

/// A punch: a closed cylinder about the z axis whose face, at z = 0 of its own frame, looks up or
/// down. Dimensions [m], all > 0.  @throws InvalidInput if one is not
TriangleSurface make_punch(double diameter, double length, double chordal_tolerance,
                           PunchFace face);

} // namespace dem
