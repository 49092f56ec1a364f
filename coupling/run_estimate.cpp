#include "coupling/run_estimate.hpp"

#include "coupling/press_set_up.hpp"
#include "dem/step/advance.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <vector>

namespace coupling {
namespace {

constexpr int n_timed_steps = 41;

} // namespace

RunSize run_size(Press const& press) {
  double const step = longest_step_of(press.setup.time_stepping)(press.world);
  auto const lengths = expected_lengths(press.programme.stages(), press.setup.powder.fill_height);
  double const simulated = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  return {.grains = static_cast<double>(press.world.grains.size()),
          .step = step,
          .simulated = simulated,
          .steps = std::ceil(simulated / step)};
}

StepCost measure_step(dem::World world, double step) {
  std::vector<double> seconds;
  for (int k = 0; k < n_timed_steps; ++k) {
    auto const start = std::chrono::steady_clock::now();
    dem::advance(world, step);
    seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::ranges::sort(seconds); // the median: the first step builds lists, another may have waited
                              // for a busy processor
  constexpr double bytes_a_grain =
      5.0 * sizeof(dem::Vec3) + 2.0 * sizeof(double) + sizeof(std::uint32_t) + 1.0;
  double const grains = bytes_a_grain * static_cast<double>(world.grains.size());
  return {.bytes = grains + static_cast<double>(world.contacts.statistics(world).bytes),
          .seconds = seconds[n_timed_steps / 2]};
}

} // namespace coupling
