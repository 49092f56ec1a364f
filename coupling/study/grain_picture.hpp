#pragma once

#include "dem/spheres.hpp"

#include <cstdint>
#include <vector>

namespace coupling::study {

/// What a picture shows, from the front: x to the right, z upwards.  [m]
struct PictureFrame {
  double half_width; ///< x from -half_width to half_width
  double bottom;     ///< z
  double top;        ///< z, > bottom
};

/// A picture of grains, row by row from the top. A pixel is 0 where there is nothing, else
///   64 component + shade,  shade = 1 + round(62 cos a),  a: between the surface and the viewer,
/// components from the fourth on look like the fourth.
struct GrainPicture {
  int width, height;
  std::vector<std::uint8_t> pixels; ///< width x height
};

/// The smallest frame that holds these grains, centred on the press axis.
PictureFrame frame_of(dem::Spheres const& grains);
PictureFrame common(PictureFrame const& a, PictureFrame const& b);

/// Grains seen along y from the side of small y, without perspective: of the grains behind a
/// pixel's centre the one whose surface is nearest.
/// @param width  [pixels]; the height follows from the frame, at least 1
GrainPicture draw_grains(dem::Spheres const& grains, PictureFrame const& frame, int width);

} // namespace coupling::study
