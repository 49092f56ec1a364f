#include "coupling/measured/curve_numbers.hpp"

#include <algorithm>
#include <cmath>

namespace coupling::measured {
namespace {

/// When the gap first falls below `level`, between readings `first` and `last`.
std::optional<Reading> crossing(Run const& run, double level, std::size_t last) {
  auto const y = run.channel("punch_gap");
  std::optional<std::size_t> before;
  for (std::size_t k = 0; k <= last; ++k) {
    if (!std::isfinite(y[k]))
      continue;
    if (y[k] <= level && before) {
      double const share = (y[*before] - level) / (y[*before] - y[k]);
      return Reading{run.time[*before] + share * (run.time[k] - run.time[*before]), k};
    }
    if (y[k] > level)
      before = k;
  }
  return {};
}

} // namespace

std::optional<Reading> smallest_of(std::span<double const> values) {
  std::optional<Reading> found;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (std::isfinite(values[k]) && (!found || values[k] < found->value))
      found = Reading{values[k], k};
  return found;
}

std::optional<Reading> largest_of(std::span<double const> values) {
  std::optional<Reading> found;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (std::isfinite(values[k]) && (!found || values[k] > found->value))
      found = Reading{values[k], k};
  return found;
}

std::optional<Closing> closing_of(Run const& run) {
  auto const y = run.channel("punch_gap");
  auto const end = smallest_of(y);
  if (!end)
    return {};
  auto const start = largest_of(y.first(end->place + 1));
  // Above the bed a press may approach as fast as it likes.
  double const from = std::min(start->value, run.press.fill_height);
  double const travel = from - end->value;
  if (!(travel > 0.0))
    return {};
  auto const early = crossing(run, from - 0.1 * travel, end->place);
  auto const late = crossing(run, from - 0.9 * travel, end->place);
  if (!early || !late || late->place < early->place + 3 || !(late->value > early->value))
    return {};
  double const duration = late->value - early->value;
  return Closing{.speed = 0.8 * travel / duration, .duration = duration, .way = 0.8 * travel};
}

} // namespace coupling::measured
