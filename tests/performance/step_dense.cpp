#include "tests/performance/dense_press.hpp"

#include "dem/step/advance.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <string>

/// step_dense PACKING BORE GAP double|mixed STEPS
/// Advances a dense bed and prints `wall seconds of the steps, of them in list builds, grains,
/// contacts`.
int main(int argc, char** argv) {
  if (argc != 6) {
    fmt::print(stderr, "usage: step_dense PACKING BORE GAP double|mixed STEPS\n");
    return 2;
  }
  try {
    performance::DenseBed const bed{argv[1], std::stod(argv[2]), std::stod(argv[3])};
    bool const is_double = argv[4] == std::string("double");
    auto press =
        performance::stand_still(bed, is_double ? dem::Precision::full : dem::Precision::mixed);
    double const dt = performance::step_of(press);
    double const built_before = press.world.contacts.statistics(press.world).seconds;
    auto const start = std::chrono::steady_clock::now();
    for (long n = std::stol(argv[5]); n > 0; --n)
      dem::advance_ahead(press.world, dt);
    std::chrono::duration<double> const wall = std::chrono::steady_clock::now() - start;
    auto const lists = press.world.contacts.statistics(press.world);
    fmt::print("{} {} {} {} {} {}\n", wall.count(), lists.seconds - built_before,
               press.world.grains.size(), lists.active, lists.listed, lists.bytes);
  } catch (std::exception const& error) {
    fmt::print(stderr, "step_dense: {}\n", error.what());
    return 1;
  }
  return 0;
}
