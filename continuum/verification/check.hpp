#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace continuum::verification {

/// A number of a problem with a known answer.
struct Check {
  std::string name;   ///< quantity and unit
  double reference;   ///< the known answer
  double result;      ///< ours
  double tolerance;   ///< of the error
  std::string source; ///< where the reference comes from

  /// |result - reference| / |reference|, absolute where the reference is 0.
  double error() const {
    return std::abs(result - reference) / (reference == 0.0 ? 1.0 : std::abs(reference));
  }
  bool passes() const { return error() <= tolerance; } ///< false for NaN
};

using Checks = std::vector<Check>;

} // namespace continuum::verification
