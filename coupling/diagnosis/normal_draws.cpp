#include "coupling/diagnosis/normal_draws.hpp"

#include "dem/packing/random_stream.hpp"

#include <cmath>
#include <numbers>

namespace coupling::diagnosis {
namespace {

/// SplitMix64's finaliser: neighbouring counters give unlike seeds.
/// Source: Steele, Lea, Flood (2014), OOPSLA, fig. 18.
std::uint64_t mixed(std::uint64_t counter) {
  counter = (counter ^ (counter >> 30)) * 0xbf58476d1ce4e5b9ULL;
  counter = (counter ^ (counter >> 27)) * 0x94d049bb133111ebULL;
  return counter ^ (counter >> 31);
}

} // namespace

Eigen::MatrixXd normal_draws(std::uint64_t seed, Eigen::Index n, int n_draws) {
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15ULL;
  Eigen::MatrixXd draws(n, n_draws);
  for (int k = 0; k < n_draws; ++k) {
    dem::RandomStream random(mixed(mixed(seed) + golden * (static_cast<std::uint64_t>(k) + 1)));
    for (Eigen::Index i = 0; i < n; i += 2) {
      double const r = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
      double const angle = 2.0 * std::numbers::pi * random.uniform();
      draws(i, k) = r * std::cos(angle);
      if (i + 1 < n)
        draws(i + 1, k) = r * std::sin(angle);
    }
  }
  return draws;
}

double log_normal_cdf(double x) {
  if (x > -30.0)
    return std::log(0.5 * std::erfc(-x / std::numbers::sqrt2));
  // Abramowitz, Stegun 26.2.12, three terms: relative error below 105 / x^8
  double const x2 = x * x;
  return -0.5 * x2 - std::log(-x * std::sqrt(2.0 * std::numbers::pi)) +
         std::log1p(-1.0 / x2 + 3.0 / (x2 * x2) - 15.0 / (x2 * x2 * x2));
}

} // namespace coupling::diagnosis
