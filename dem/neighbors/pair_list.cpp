#include "dem/neighbors/pair_list.hpp"

#include "dem/expect.hpp"
#include "dem/neighbors/grid_level.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace dem {

namespace {

using Row = std::uint32_t;

/// Level of each grain: cells of level l are 2^l times those of the smallest grains and hold a
/// grain's diameter.
std::vector<std::uint8_t> levels_of(std::span<double const> reach, double smallest) {
  std::vector<std::uint8_t> level(reach.size());
  for (std::size_t i = 0; i < reach.size(); ++i) {
    int l = std::max(0, std::ilogb(reach[i] / smallest));
    if (reach[i] > std::ldexp(smallest, l))
      ++l;
    level[i] = static_cast<std::uint8_t>(std::min(l, 30));
  }
  return level;
}

/// Pairs as a chunk of rows found them: row first + k found n_found[k] of `other`.
struct FoundPairs {
  std::vector<Row> other;
  std::vector<Row> n_found;

  /// visit(smaller row, larger row)
  template <class Visit> void for_each(Row first, Visit&& visit) const {
    auto other_row = other.begin();
    for (Row k = 0; k < n_found.size(); ++k)
      for (Row m = 0; m < n_found[k]; ++m, ++other_row)
        visit(std::min(first + k, *other_row), std::max(first + k, *other_row));
  }
};

// Chunks of fixed size keep the result independent of the number of threads.
constexpr std::size_t chunk = 1024;

/// Sorts pairs by owner, the smaller row, and partner. What was found is let go on the way: a list
/// is the largest thing a build holds.
PairList sort_by_owner(std::size_t n, std::vector<FoundPairs>&& found) {
  PairList list;
  list.start.assign(n + 1, 0);
  for (std::size_t c = 0; c < found.size(); ++c)
    found[c].for_each(static_cast<Row>(c * chunk), [&](Row a, Row) { ++list.start[a + 1]; });
  std::partial_sum(list.start.begin(), list.start.end(), list.start.begin());
  list.partner.resize(list.start.back());
  std::vector<Row> next(list.start.begin(), list.start.end() - 1);
  for (std::size_t c = 0; c < found.size(); ++c) {
    found[c].for_each(static_cast<Row>(c * chunk),
                      [&](Row a, Row b) { list.partner[next[a]++] = b; });
    found[c] = {};
  }
#pragma omp parallel for schedule(static) if (n > 1024)
  for (std::size_t i = 0; i < n; ++i)
    std::sort(list.partner.begin() + list.start[i], list.partner.begin() + list.start[i + 1]);
  return list;
}

} // namespace

PairList find_pairs(std::span<Vec3 const> position, std::span<double const> reach) {
  EXPECT(position.size() == reach.size());
  std::size_t const n = position.size();
  if (n == 0)
    return {.start = {0}, .partner = {}};
  double const smallest = *std::ranges::min_element(reach);
  auto const level = levels_of(reach, smallest);
  std::size_t const n_levels = *std::ranges::max_element(level) + 1u;
  std::vector<std::vector<Row>> rows(n_levels);
  for (Row i = 0; i < n; ++i)
    rows[level[i]].push_back(i);
  GridBox const box = grid_box(position);
  std::vector<GridLevel> grids;
  for (std::size_t l = 0; l < n_levels; ++l)
    grids.emplace_back(box, 2.0 * std::ldexp(smallest, static_cast<int>(l)), position, rows[l]);

  std::vector<FoundPairs> found((n + chunk - 1) / chunk);
#pragma omp parallel for schedule(dynamic, 1) if (found.size() > 1)
  for (std::size_t part = 0; part < found.size(); ++part) {
    auto& [other, n_found] = found[part];
    for (Row i = static_cast<Row>(part * chunk); i < std::min(n, (part + 1) * chunk); ++i) {
      std::size_t const before = other.size();
      auto const consider = [&](Row j) {
        double const sum = reach[i] + reach[j];
        if ((position[i] - position[j]).squaredNorm() < sum * sum)
          other.push_back(j);
      };
      grids[level[i]].near(position[i], [&](Row j) {
        if (j > i)
          consider(j);
      });
      for (std::size_t l = level[i] + 1u; l < n_levels; ++l)
        grids[l].near(position[i], consider);
      n_found.push_back(static_cast<Row>(other.size() - before));
    }
    other.shrink_to_fit();
  }
  return sort_by_owner(n, std::move(found));
}

PairList find_pairs_by_brute_force(std::span<Vec3 const> position, std::span<double const> reach) {
  PairList list{.start = {0}, .partner = {}};
  for (Row i = 0; i < position.size(); ++i) {
    for (Row j = i + 1; j < position.size(); ++j) {
      double const sum = reach[i] + reach[j];
      if ((position[i] - position[j]).squaredNorm() < sum * sum)
        list.partner.push_back(j);
    }
    list.start.push_back(static_cast<Row>(list.partner.size()));
  }
  return list;
}

std::vector<std::uint32_t> order_along_curve(std::span<Vec3 const> position) {
  GridBox const box = grid_box(position);
  double const extent = std::max((box.high - box.low).maxCoeff(), 1e-300);
  auto const spread = [](std::uint64_t x) { // two zero bits after each of 20
    x &= 0xfffff;
    x = (x | x << 32) & 0x1f00000000ffffull;
    x = (x | x << 16) & 0x1f0000ff0000ffull;
    x = (x | x << 8) & 0x100f00f00f00f00full;
    x = (x | x << 4) & 0x10c30c30c30c30c3ull;
    x = (x | x << 2) & 0x1249249249249249ull;
    return x;
  };
  std::vector<std::pair<std::uint64_t, std::uint32_t>> key(position.size());
  for (std::uint32_t i = 0; i < position.size(); ++i) {
    Vec3 const at = ((position[i] - box.low) / extent).cwiseMax(0.0).cwiseMin(1.0) * 1048575.0;
    key[i] = {spread(static_cast<std::uint64_t>(at.x())) |
                  spread(static_cast<std::uint64_t>(at.y())) << 1 |
                  spread(static_cast<std::uint64_t>(at.z())) << 2,
              i};
  }
  std::ranges::sort(key);
  std::vector<std::uint32_t> order(position.size());
  for (std::size_t k = 0; k < key.size(); ++k)
    order[k] = key[k].second;
  return order;
}

} // namespace dem
