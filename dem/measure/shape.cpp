#include "dem/measure/shape.hpp"

#include "dem/expect.hpp"
#include "dem/measure/compact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace dem {
namespace {

constexpr int n_sectors = 36;
constexpr double sector_angle = 2.0 * pi / n_sectors;

/// A grain's largest section in a level's slab, in polar coordinates about the axis.
struct Circle {
  double distance; // [m], of the centre
  double angle;    // [rad], of the centre
  double radius;   // [m]
};

/// Farthest point of a circle from the axis within a sector: straight behind the centre if that
/// direction is in it, else where the nearer edge of the sector leaves the circle. 0 where they do
/// not meet.
double farthest_in_sector(Circle const& circle, int sector) {
  double const from_middle = std::remainder(circle.angle - (sector + 0.5) * sector_angle, 2.0 * pi);
  double const beyond_edge = std::abs(from_middle) - 0.5 * sector_angle;
  if (beyond_edge <= 0.0)
    return circle.distance + circle.radius;
  double const across = circle.distance * std::sin(beyond_edge);
  double const half_chord_squared = circle.radius * circle.radius - across * across;
  if (half_chord_squared < 0.0)
    return 0.0;
  return std::max(0.0, circle.distance * std::cos(beyond_edge) + std::sqrt(half_chord_squared));
}

/// @param low, high  [m], of the level's slab
double average_maximum_radius(Spheres const& grains, double floor, double low, double high) {
  std::array<double, n_sectors> farthest{};
  for (std::size_t i = 0; i < grains.size(); ++i) {
    Vec3 const& centre = grains.position[i];
    double const off_slab = std::max({low - centre[2], centre[2] - high, 0.0}),
                 R = grains.radius[i];
    if (!is_in_compact(grains, i, floor) || off_slab >= R)
      continue;
    Circle const circle{.distance = std::hypot(centre[0], centre[1]),
                        .angle = std::atan2(centre[1], centre[0]),
                        .radius = std::sqrt(R * R - off_slab * off_slab)};
    for (int sector = 0; sector < n_sectors; ++sector)
      farthest[sector] = std::max(farthest[sector], farthest_in_sector(circle, sector));
  }
  return std::accumulate(farthest.begin(), farthest.end(), 0.0) / n_sectors;
}

} // namespace

std::vector<double> compact_shape(Spheres const& grains, double floor) {
  std::vector<double> shape{compact_extent(grains, floor).height()};
  double const step = shape_top / n_shape_levels;
  for (int level = 0; level < n_shape_levels; ++level)
    shape.push_back(
        average_maximum_radius(grains, floor, floor + level * step, floor + (level + 1) * step));
  return shape;
}

double shape_similarity(std::span<double const> a, std::span<double const> b) {
  EXPECT(a.size() == b.size());
  double aa = 0.0, bb = 0.0, ab = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    aa += a[k] * a[k];
    bb += b[k] * b[k];
    ab += a[k] * b[k];
  }
  double const either = aa + bb - ab;
  return either > 0.0 ? ab / either : 1.0;
}

int shape_quality(double similarity) {
  EXPECT(std::isfinite(similarity));
  if (similarity >= 0.875)
    return 5;
  if (similarity >= 0.75)
    return 4;
  if (similarity >= 0.625)
    return 3;
  return similarity >= 0.5 ? 2 : 1;
}

} // namespace dem
