#pragma once

#include <vector>

namespace dem {

/// Points and weights of an integral over -1 .. 1.
struct QuadratureRule {
  std::vector<double> points;
  std::vector<double> weights;
};

/// Gauss-Legendre rule of n >= 1 points, exact to degree 2n - 1; nodes by Newton's method on P_n.
/// Source: Abramowitz and Stegun, Handbook of Mathematical Functions (1964), 25.4.29.
QuadratureRule gauss_legendre(int n);

} // namespace dem
