#pragma once

#include "dem/vec3.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace dem {

/// A hierarchical cell grid over a box for spheres sorted by radius, largest first: one grid a
/// level, a level holds radii within a factor 2. A sphere meets its coarser or equal partners by
/// looking only upwards, so the cost of a query does not depend on the size ratio.
class LevelGrid {
public:
  /// @param radii   [m], largest first, of every sphere that may ever be inserted
  /// @param low     [m], lower corner of the box that holds all centres
  /// @param high    [m], upper corner
  LevelGrid(std::span<double const> radii, Vec3 const& low, Vec3 const& high);

  void insert(std::uint32_t sphere, Vec3 const& centre);
  void clear();

  /// Calls `meet(sphere, centre, radius)` for every inserted sphere of the levels down to that of
  /// `seeker` whose surface may be within `reach` [m] of the seeker's, and stops when it returns
  /// true.
  /// @returns whether it was stopped
  template <class Meet>
  bool meet_near(std::uint32_t seeker, Vec3 const& centre, double reach, Meet&& meet) const {
    for (std::size_t l = 0; l <= level_of_[seeker]; ++l)
      if (meet_in_level(levels_[l], centre, radius_[seeker] + levels_[l].largest_radius + reach,
                        meet))
        return true;
    return false;
  }

private:
  static constexpr std::uint32_t none = 0xffffffffu;
  struct Level {
    double largest_radius;   // [m]
    double cells_per_length; // [1/m]
    std::array<std::int32_t, 3> n_cells;
    std::vector<std::uint32_t> first; // per cell, head of a chain of spheres
  };
  struct Node {
    Vec3 centre;
    std::uint32_t next;
  };

  std::int32_t cell_along(Level const& level, double x, int axis) const;
  std::size_t cell_at(Level const& level, std::int32_t i, std::int32_t j, std::int32_t k) const {
    return (static_cast<std::size_t>(k) * level.n_cells[1] + j) * level.n_cells[0] + i;
  }

  template <class Meet>
  bool meet_in_level(Level const& level, Vec3 const& centre, double range, Meet&& meet) const {
    std::array<std::int32_t, 3> from, to;
    for (int axis = 0; axis < 3; ++axis) {
      from[axis] = cell_along(level, centre[axis] - range, axis);
      to[axis] = cell_along(level, centre[axis] + range, axis);
    }
    for (auto k = from[2]; k <= to[2]; ++k)
      for (auto j = from[1]; j <= to[1]; ++j)
        for (auto i = from[0]; i <= to[0]; ++i)
          for (auto s = level.first[cell_at(level, i, j, k)]; s != none; s = nodes_[s].next)
            if (meet(s, nodes_[s].centre, radius_[s]))
              return true;
    return false;
  }

  Vec3 low_, high_;
  std::vector<double> radius_;
  std::vector<std::size_t> level_of_; // per sphere
  std::vector<Level> levels_;         // coarsest first
  std::vector<Node> nodes_;           // per sphere
};

} // namespace dem
