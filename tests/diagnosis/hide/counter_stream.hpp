#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace hidden {

/// What a draw is for. A draw is a function of (seed, purpose, index) alone: adding a draw
/// somewhere moves no other one.
enum class Purpose : std::uint64_t {
  cause = 1,
  size,
  powder,
  repeat,
  order,
  clock,
  noise,
  simulation,
  extra,
};

/// Counter-based stream of random numbers. The mixer is splitmix64's (Steele, Lea & Flood,
/// OOPSLA 2014), applied to the key and the counter.
class CounterStream {
public:
  CounterStream(std::uint64_t seed, Purpose purpose, std::uint64_t index = 0)
      : key_(mixed(mixed(mixed(seed) + static_cast<std::uint64_t>(purpose)) + index)) {}

  /// @return in (0, 1)
  double uniform() { return (static_cast<double>(mixed(key_ + ++count_) >> 11) + 0.5) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Standard normal, by Box and Muller.
  double normal() {
    double const radius = std::sqrt(-2.0 * std::log(uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }
  /// @return 0 to n - 1
  int below(int n) { return static_cast<int>(uniform() * n); }

private:
  static std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
  }
  std::uint64_t key_, count_ = 0;
};

} // namespace hidden
