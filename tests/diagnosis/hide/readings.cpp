#include "tests/diagnosis/hide/readings.hpp"

#include "tests/diagnosis/hide/counter_stream.hpp"

#include <cmath>

namespace hidden {
namespace {

/// Linear between the moments around t.
Moment moment_at(Cycle const& cycle, double t, std::size_t& from) {
  auto const& all = cycle.moments;
  while (from + 2 < all.size() && all[from + 1].time < t)
    ++from;
  auto const &a = all[from], &b = all[from + 1];
  double const share = std::min(1.0, (t - a.time) / (b.time - a.time));
  auto const mean = [&](double x, double y) { return x + share * (y - x); };
  return {.time = t,
          .gap = mean(a.gap, b.gap),
          .height = mean(a.height, b.height),
          .upper = mean(a.upper, b.upper),
          .lower = mean(a.lower, b.lower),
          .radial = mean(a.radial, b.radial)};
}

} // namespace

double Sensor::at(double reading) const {
  return std::hypot(sd, relative * reading);
}

Readings read_cycle(Cycle const& cycle, Protocol const& protocol, std::uint64_t seed,
                    std::uint64_t run) {
  CounterStream clock(seed, Purpose::clock, run), noise(seed, Purpose::noise, run);
  auto const read = [&](Sensor const& sensor, double y) {
    return y + sensor.at(y) * noise.normal();
  };
  double const interval = clock.uniform(0.25, 0.5) / std::sqrt(protocol.speed_down / (mm / 60.0));
  Readings result{};
  std::size_t place = 0;
  for (double t = interval * clock.uniform(); t < protocol.end_time();
       t += interval * clock.uniform(0.6, 1.4)) {
    auto at = moment_at(cycle, t, place);
    at.gap = protocol.gap_at(t);
    result.time.push_back(t);
    result.gap.push_back(read(gap_sensor, at.gap));
    result.upper.push_back(read(force_sensor, at.upper));
    result.lower.push_back(read(force_sensor, at.lower));
    result.radial.push_back(read(pressure_sensor, at.radial));
  }
  result.compact_height = cycle.compact_height + height_sd * noise.normal();
  result.ejection_force = cycle.ejection_force + ejection_sd * noise.normal();
  return result;
}

} // namespace hidden
