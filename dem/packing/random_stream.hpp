#pragma once

#include <cstdint>
#include <random>

namespace dem {

/// Random numbers with a definition that no standard library may change: the engine's sequence is
/// fixed by the standard, std::uniform_real_distribution is not, so the conversion is our own.
class RandomStream {
public:
  explicit RandomStream(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

  /// Uniform in [-1, 1), exact to the last bit.
  double symmetric() { return 2.0 * uniform() - 1.0; }

  /// Uniform in 0 .. count - 1 (the bias is below count 2^-53).
  std::uint64_t below(std::uint64_t count) {
    return static_cast<std::uint64_t>(uniform() * static_cast<double>(count));
  }

private:
  std::mt19937_64 engine_;
};

} // namespace dem
