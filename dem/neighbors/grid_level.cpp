#include "dem/neighbors/grid_level.hpp"

#include <cmath>

namespace dem {

GridBox grid_box(std::span<Vec3 const> position) {
  Vec3 mean = Vec3::Zero(), square = Vec3::Zero();
  Vec3 low = position[0], high = position[0];
  for (Vec3 const& x : position) {
    mean += x;
    square += x.cwiseProduct(x);
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  double const n = static_cast<double>(position.size());
  mean /= n;
  Vec3 const spread = 4.0 * (square / n - mean.cwiseProduct(mean)).cwiseMax(0.0).cwiseSqrt();
  return {low.cwiseMax(mean - spread), high.cwiseMin(mean + spread)};
}

GridLevel::GridLevel(GridBox const& box, double cell_size, std::span<Vec3 const> position,
                     std::vector<std::uint32_t> const& rows)
    : low_(box.low) {
  // A level with few grains needs few cells: larger cells are always complete, only slower.
  auto const count = [&](int axis) {
    double const cells = std::floor((box.high[axis] - box.low[axis]) / cell_size);
    return std::clamp(static_cast<int>(std::min(cells, 1000.0)) + 1, 1, 1001);
  };
  while (true) {
    n_ = {count(0), count(1), count(2)};
    if (static_cast<double>(n_[0]) * n_[1] * n_[2] <= 8.0 * static_cast<double>(rows.size()) + 64.0)
      break;
    cell_size *= 1.25;
  }
  for (int axis = 0; axis < 3; ++axis)
    cell_size = std::max(cell_size, (box.high[axis] - box.low[axis]) / 1000.0);
  per_metre_ = 1.0 / cell_size;

  std::vector<std::uint32_t> cell(rows.size());
  start_.assign(static_cast<std::size_t>(n_[0]) * n_[1] * n_[2] + 1, 0);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    auto const c = cell_of(position[rows[k]]);
    cell[k] =
        static_cast<std::uint32_t>((static_cast<std::size_t>(c[2]) * n_[1] + c[1]) * n_[0] + c[0]);
    ++start_[cell[k] + 1];
  }
  for (std::size_t c = 1; c < start_.size(); ++c)
    start_[c] += start_[c - 1];
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  rows_.resize(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k)
    rows_[next[cell[k]]++] = rows[k];
}

std::array<int, 3> GridLevel::cell_of(Vec3 const& x) const {
  std::array<int, 3> c;
  for (int axis = 0; axis < 3; ++axis) {
    double const at = std::floor((x[axis] - low_[axis]) * per_metre_);
    c[axis] = static_cast<int>(std::clamp(at, 0.0, static_cast<double>(n_[axis] - 1)));
  }
  return c;
}

} // namespace dem
