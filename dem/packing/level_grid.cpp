#include "dem/packing/level_grid.hpp"

#include "dem/expect.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

LevelGrid::LevelGrid(std::span<double const> radii, Vec3 const& low, Vec3 const& high)
    : low_(low), high_(high), radius_(radii.begin(), radii.end()),
      nodes_(radii.size(), {Vec3::Zero(), none}) {
  EXPECT(std::ranges::is_sorted(radii, std::ranges::greater{}));
  std::vector<std::size_t> n_spheres;
  for (double radius : radii) {
    if (levels_.empty() || radius <= 0.5 * levels_.back().largest_radius) {
      levels_.push_back(
          {.largest_radius = radius, .cells_per_length = 0.0, .n_cells = {}, .first = {}});
      n_spheres.push_back(0);
    }
    ++n_spheres.back();
    level_of_.push_back(levels_.size() - 1);
  }
  Vec3 const size = high - low;
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    // Half a sphere a cell at most: a level with few small spheres must not cost a cell for each of
    // its diameters.
    double const roomy = std::cbrt(0.5 * size.prod() / static_cast<double>(n_spheres[l]));
    double const width = std::max(2.0 * levels_[l].largest_radius, roomy);
    levels_[l].cells_per_length = 1.0 / width;
    std::size_t n_cells = 1;
    for (int axis = 0; axis < 3; ++axis) {
      levels_[l].n_cells[axis] = std::max(1, static_cast<int>(std::ceil(size[axis] / width)));
      n_cells *= static_cast<std::size_t>(levels_[l].n_cells[axis]);
    }
    levels_[l].first.assign(n_cells, none);
  }
}

std::int32_t LevelGrid::cell_along(Level const& level, double x, int axis) const {
  double const clamped = std::clamp(x, low_[axis], high_[axis]);
  auto const cell = static_cast<std::int32_t>((clamped - low_[axis]) * level.cells_per_length);
  return std::min(cell, level.n_cells[axis] - 1);
}

void LevelGrid::insert(std::uint32_t sphere, Vec3 const& centre) {
  Level& level = levels_[level_of_[sphere]];
  auto& first =
      level.first[cell_at(level, cell_along(level, centre[0], 0), cell_along(level, centre[1], 1),
                          cell_along(level, centre[2], 2))];
  nodes_[sphere] = {centre, first};
  first = sphere;
}

void LevelGrid::clear() {
  for (Level& level : levels_)
    std::ranges::fill(level.first, none);
}

} // namespace dem
