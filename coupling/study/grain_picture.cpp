#include "coupling/study/grain_picture.hpp"

#include "dem/expect.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coupling::study {
namespace {

/// The first and last pixel whose centre lies in [from, to], of n pixels of a size.
std::pair<int, int> pixels_in(double from, double to, double size, int n) {
  return {std::max(0, static_cast<int>(std::ceil(from / size - 0.5))),
          std::min(n - 1, static_cast<int>(std::floor(to / size - 0.5)))};
}

} // namespace

PictureFrame frame_of(dem::Spheres const& grains) {
  PictureFrame frame{0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < grains.size(); ++i) {
    auto const& x = grains.position[i];
    double const R = grains.radius[i];
    frame.half_width = std::max(frame.half_width, std::abs(x.x()) + R);
    frame.bottom = std::min(frame.bottom, x.z() - R);
    frame.top = std::max(frame.top, x.z() + R);
  }
  return frame;
}

PictureFrame common(PictureFrame const& a, PictureFrame const& b) {
  return {std::max(a.half_width, b.half_width), std::min(a.bottom, b.bottom),
          std::max(a.top, b.top)};
}

GrainPicture draw_grains(dem::Spheres const& grains, PictureFrame const& frame, int width) {
  EXPECT(width > 0 && frame.half_width > 0.0 && frame.top > frame.bottom);
  double const size = 2.0 * frame.half_width / width; // of a pixel
  int const height = std::max(1, static_cast<int>(std::lround((frame.top - frame.bottom) / size)));
  auto const n_pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  GrainPicture picture{width, height, std::vector<std::uint8_t>(n_pixels, 0)};
  std::vector<double> nearest(n_pixels, std::numeric_limits<double>::infinity());
  for (std::size_t g = 0; g < grains.size(); ++g) {
    auto const& centre = grains.position[g];
    double const R = grains.radius[g];
    double const x = centre.x() + frame.half_width, z = frame.top - centre.z();
    auto const [left, right] = pixels_in(x - R, x + R, size, width);
    auto const [top, bottom] = pixels_in(z - R, z + R, size, height);
    for (int row = top; row <= bottom; ++row)
      for (int column = left; column <= right; ++column) {
        double const dx = (column + 0.5) * size - x, dz = (row + 0.5) * size - z;
        double const rest = R * R - dx * dx - dz * dz;
        if (rest < 0.0)
          continue;
        double const depth = centre.y() - std::sqrt(rest);
        auto const k = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(column);
        if (depth >= nearest[k])
          continue;
        nearest[k] = depth;
        auto const component = std::min<int>(3, grains.material[g]);
        picture.pixels[k] = static_cast<std::uint8_t>(
            64 * component + 1 + static_cast<int>(std::lround(62.0 * std::sqrt(rest) / R)));
      }
  }
  return picture;
}

} // namespace coupling::study
