#include "coupling/reduced/mean_cycle.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace coupling::reduced {
namespace {

constexpr double same_turn = 1e-3; // of the height

struct Bearing {
  double upper = 0.0, lower = 0.0, pressure = 0.0;
};

/// Records in which the bed is as low as never before, or has opened as far as never since, by
/// height.
class Branch {
public:
  Branch(SimulatedCycle const& cycle, std::size_t first, std::size_t end, double sign)
      : cycle_(cycle) {
    for (std::size_t k = first; k < end; ++k)
      if (records_.empty() || sign * cycle.height[k] > sign * cycle.height[records_.back()])
        records_.push_back(k);
    if (sign < 0.0)
      std::ranges::reverse(records_);
  }

  /// Between records; those at the ends go on as straight lines.
  Bearing at(double height) const {
    auto after = std::ranges::lower_bound(records_, height, {},
                                          [&](std::size_t k) { return cycle_.height[k]; });
    if (after == records_.end())
      return at_record(records_.back()); // above the fill
    if (after == records_.begin())
      after = std::next(after);
    auto const [a, b] = std::pair{*std::prev(after), *after};
    double const s = (height - cycle_.height[a]) / (cycle_.height[b] - cycle_.height[a]);
    auto const from = at_record(a), to = at_record(b);
    return {std::lerp(from.upper, to.upper, s), std::lerp(from.lower, to.lower, s),
            std::lerp(from.pressure, to.pressure, s)};
  }

private:
  Bearing at_record(std::size_t k) const {
    return {cycle_.upper[k], cycle_.lower[k], cycle_.radial_pressure[k]};
  }
  SimulatedCycle const& cycle_;
  std::vector<std::size_t> records_; ///< by height
};

struct Branches {
  Branch closing, opening;
};
Branches branches_of(SimulatedCycle const& cycle, std::size_t turn) {
  return {{cycle, 0, turn + 1, -1.0}, {cycle, turn, cycle.height.size(), 1.0}};
}

} // namespace

SimulatedCycle mean_cycle(std::span<SimulatedCycle const> cycles) {
  EXPECT(!cycles.empty());
  auto const& first = cycles.front();
  if (cycles.size() == 1)
    return first;
  auto const parts = parts_of(first);
  std::vector<Branches> branches;
  for (auto const& cycle : cycles) {
    auto const turn = parts_of(cycle).turn;
    VALIDATE(std::abs(cycle.height[turn] - first.height[parts.turn]) <
                 same_turn * first.height[parts.turn],
             fmt::format("simulated cycles: one turns at {:g} m, the first at {:g} m. Were they "
                         "pressed by the same programme?",
                         cycle.height[turn], first.height[parts.turn]));
    branches.push_back(branches_of(cycle, turn));
  }
  SimulatedCycle mean;
  auto const add = [&](std::size_t record, bool is_opening) {
    Bearing sum;
    double const height = first.height[record];
    for (auto const& one : branches) {
      auto const at = (is_opening ? one.opening : one.closing).at(height);
      sum.upper += at.upper, sum.lower += at.lower, sum.pressure += at.pressure;
    }
    auto const n = static_cast<double>(branches.size());
    mean.height.push_back(height);
    mean.upper.push_back(sum.upper / n);
    mean.lower.push_back(sum.lower / n);
    mean.radial_pressure.push_back(sum.pressure / n);
  };
  for (std::size_t k = 0; k <= parts.turn; ++k)
    add(k, false);
  for (std::size_t const k : parts.unloading)
    add(k, true);
  return mean;
}

} // namespace coupling::reduced
