#include "dem/packing/relax_overlaps.hpp"

#include "dem/packing/level_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace dem {
namespace {

constexpr double wanted_gap =
    1e-3; // of the sum of the radii: overshoot makes the convergence finite

struct Pair {
  std::uint32_t i, j;
};

std::vector<Pair> list_pairs(std::span<Vec3 const> centres, std::span<double const> radii,
                             double skin, LevelGrid& grid) {
  grid.clear();
  for (std::uint32_t i = 0; i < centres.size(); ++i)
    grid.insert(i, centres[i]);
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < centres.size(); ++i)
    grid.meet_near(i, centres[i], skin, [&](std::uint32_t j, Vec3 const& centre, double radius) {
      double const near = radii[i] + radius + skin;
      // A partner is larger or equal, and those come first.
      if (j < i && (centre - centres[i]).squaredNorm() < near * near)
        pairs.push_back({i, j});
      return false;
    });
  return pairs;
}

double overlap_share(std::vector<Vec3> const& centres, std::span<double const> radii, Pair pair) {
  double const sum = radii[pair.i] + radii[pair.j];
  return 1.0 - (centres[pair.i] - centres[pair.j]).norm() / sum;
}

/// @returns how far the grain that moved more went [m]
double push_apart(std::vector<Vec3>& centres, std::span<double const> radii, Pair pair) {
  Vec3 const between = centres[pair.i] - centres[pair.j];
  double const distance = between.norm();
  double const lacking = (radii[pair.i] + radii[pair.j]) * (1.0 + wanted_gap) - distance;
  if (lacking <= 0.0)
    return 0.0;
  Vec3 const n = distance > 0.0 ? Vec3(between / distance) : Vec3(Vec3::UnitX());
  double const volume_i = std::pow(radii[pair.i], 3), volume_j = std::pow(radii[pair.j], 3);
  double const share_i = volume_j / (volume_i + volume_j);
  centres[pair.i] += share_i * lacking * n;
  centres[pair.j] -= (1.0 - share_i) * lacking * n;
  return std::max(share_i, 1.0 - share_i) * lacking;
}

double largest_overlap(std::vector<Vec3> const& centres, std::span<double const> radii,
                       std::span<Pair const> pairs) {
  double largest = -packing_clearance;
  for (Pair pair : pairs)
    largest = std::max(largest, overlap_share(centres, radii, pair));
  return largest;
}

double largest_move(std::span<Vec3 const> from, std::span<Vec3 const> to) {
  double largest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i)
    largest = std::max(largest, (to[i] - from[i]).squaredNorm());
  return std::sqrt(largest);
}

} // namespace

Vec3 clamp_inside(Vec3 const& centre, double radius, FillVolume const& volume) {
  double const keep = radius * (1.0 + packing_clearance);
  double const room = volume.radius - volume.wall_clearance - keep;
  Vec3 inside = centre;
  double const distance = std::hypot(centre[0], centre[1]);
  // The factor takes the rounding of the product, so that the result is inside and not just nearly.
  if (distance > room)
    inside.head<2>() *= room / distance * (1.0 - 1e-15);
  inside[2] = std::clamp(centre[2], keep, volume.height - keep);
  return inside;
}

Relaxation relax_overlaps(std::vector<Vec3>& centres, std::span<double const> radii,
                          FillVolume const& volume, int max_sweeps) {
  if (centres.empty())
    return {.is_free = true, .n_sweeps = 0, .largest_overlap = 0.0};
  Vec3 const corner(volume.radius, volume.radius, 0.0);
  LevelGrid grid(radii, -corner, corner + Vec3(0.0, 0.0, volume.height));
  double const skin = 0.4 * radii.back();
  std::vector<Vec3> listed_at = centres;
  std::vector<Pair> pairs = list_pairs(centres, radii, skin, grid);
  double overlap = largest_overlap(centres, radii, pairs);
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    if (overlap <= -packing_clearance)
      return {.is_free = true, .n_sweeps = sweep, .largest_overlap = overlap};
    for (Pair pair : pairs)
      push_apart(centres, radii, pair);
    for (std::size_t i = 0; i < centres.size(); ++i)
      centres[i] = clamp_inside(centres[i], radii[i], volume);
    if (largest_move(listed_at, centres) > 0.5 * skin) {
      listed_at = centres;
      pairs = list_pairs(centres, radii, skin, grid);
    }
    overlap = largest_overlap(centres, radii, pairs);
  }
  return {
      .is_free = overlap <= -packing_clearance, .n_sweeps = max_sweeps, .largest_overlap = overlap};
}

} // namespace dem
