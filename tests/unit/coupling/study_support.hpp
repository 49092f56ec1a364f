#pragma once

#include "coupling/study/response_surface.hpp"
#include "dem/expect.hpp"
#include "dem/packing/random_stream.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace study_support {

inline std::string message_of(auto const& act) {
  try {
    act();
  } catch (dem::InvalidInput const& error) {
    return error.what();
  }
  return "no error";
}

/// Standard normal numbers by Box and Muller, the same on every platform.
class Noise {
public:
  explicit Noise(std::uint64_t seed) : random_(seed) {}

  double operator()() {
    double const r = std::sqrt(-2.0 * std::log(1.0 - random_.uniform()));
    return r * std::cos(2.0 * std::numbers::pi * random_.uniform());
  }
  Eigen::VectorXd vector(Eigen::Index n) {
    Eigen::VectorXd v(n);
    for (double& one : v)
      one = (*this)();
    return v;
  }
  dem::RandomStream& uniform() { return random_; }

private:
  dem::RandomStream random_;
};

inline std::vector<std::string> letters(Eigen::Index n) {
  std::vector<std::string> names;
  for (Eigen::Index k = 0; k < n; ++k)
    names.emplace_back(1, static_cast<char>('A' + k));
  return names;
}

inline coupling::study::Observations observed(Eigen::MatrixXd coded, Eigen::VectorXd response,
                                              std::string name = "y") {
  auto names = letters(coded.cols());
  return {std::move(names), std::move(coded), std::move(name), std::move(response)};
}

/// Whether a count of `n` trials with probability `p` could be so far from n p once in a million
/// times at most (normal approximation, 4.9 standard deviations).
inline bool is_within_chance(int count, int n, double p) {
  return std::abs(count - n * p) < 4.9 * std::sqrt(n * p * (1.0 - p)) + 1.0;
}

} // namespace study_support
