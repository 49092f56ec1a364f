#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace near {

/// |value - expected| <= relative |expected|, both sides.
inline ::testing::AssertionResult relative(double value, double expected, double tolerance) {
  double const error = std::abs(value - expected);
  if (error <= tolerance * std::abs(expected))
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << value << " against " << expected << ": relative error "
                                       << error / std::abs(expected) << " > " << tolerance;
}

/// Largest deviation of a series against its own largest expected value, the measure of the
/// acceptance table.
class LargestDeviation {
public:
  explicit LargestDeviation(std::string quantity) : quantity_(std::move(quantity)) {}

  void add(auto const& value, auto const& expected) {
    largest_ = std::max(largest_, static_cast<double>(expected.norm()));
    deviation_ = std::max(deviation_, static_cast<double>((value - expected).norm()));
    // A NaN compares false with everything, so it must be caught where it enters.
    finite_ = finite_ && std::isfinite(static_cast<double>(value.norm()));
  }

  /// @param floor  a scale [of the quantity] below which a vanishing quantity counts as zero
  ::testing::AssertionResult within(double tolerance, double floor = 0.0) const {
    if (finite_ && deviation_ <= tolerance * std::max(largest_, floor))
      return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << quantity_ << " deviates by " << deviation_ << ", " << deviation_ / largest_
           << " of its largest value " << largest_ << (finite_ ? "" : " (not finite)")
           << "; allowed " << tolerance;
  }

  double ratio() const { return largest_ > 0.0 ? deviation_ / largest_ : deviation_; }
  double largest() const { return largest_; }

private:
  std::string quantity_;
  double largest_ = 0.0, deviation_ = 0.0;
  bool finite_ = true;
};

} // namespace near
