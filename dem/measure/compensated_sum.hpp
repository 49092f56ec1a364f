#pragma once

#include <cmath>

namespace dem {

/// A sum of many terms whose error does not grow with their number.
/// Source: Neumaier, Z. Angew. Math. Mech. 54 (1974) 39.
class CompensatedSum {
public:
  CompensatedSum& operator+=(double term) {
    double const next = sum_ + term;
    lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
    return *this;
  }
  double value() const { return sum_ + lost_; }

private:
  double sum_ = 0.0, lost_ = 0.0;
};

} // namespace dem
