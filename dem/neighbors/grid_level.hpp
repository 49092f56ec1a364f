#pragma once

#include "dem/vec3.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace dem {

/// The part of space that a grid covers. Positions outside are counted to the nearest cell:
/// clamping brings no two cells further apart, so neighbours stay neighbours however far a lost
/// grain flies.
struct GridBox {
  Vec3 low, high; ///< [m]
};

/// Box of the grains, cut at four standard deviations from their mean so that strays cannot blow up
/// the grid.
GridBox grid_box(std::span<Vec3 const> position);

/// A uniform grid over the grains of one size level, as a counting sort of their rows.
class GridLevel {
public:
  /// @param rows       of `position`, the grains of this level, ascending
  /// @param cell_size  [m]
  GridLevel(GridBox const& box, double cell_size, std::span<Vec3 const> position,
            std::vector<std::uint32_t> const& rows);

  bool empty() const { return rows_.empty(); }

  /// Calls visit(row) for every grain in the 27 cells around `x`.
  template <class Visit> void near(Vec3 const& x, Visit&& visit) const {
    auto const c = cell_of(x);
    for (int k = std::max(c[2] - 1, 0); k <= std::min(c[2] + 1, n_[2] - 1); ++k)
      for (int j = std::max(c[1] - 1, 0); j <= std::min(c[1] + 1, n_[1] - 1); ++j) {
        // Cells along x follow each other: one run of rows covers all three.
        std::size_t const row = (static_cast<std::size_t>(k) * n_[1] + j) * n_[0];
        std::uint32_t const begin = start_[row + std::max(c[0] - 1, 0)];
        std::uint32_t const end = start_[row + std::min(c[0] + 1, n_[0] - 1) + 1];
        for (std::uint32_t s = begin; s < end; ++s)
          visit(rows_[s]);
      }
  }

private:
  std::array<int, 3> cell_of(Vec3 const& x) const;

  Vec3 low_;
  double per_metre_;
  std::array<int, 3> n_;
  std::vector<std::uint32_t> start_; // n_cells + 1
  std::vector<std::uint32_t> rows_;
};

} // namespace dem
