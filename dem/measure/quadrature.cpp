#include "dem/measure/quadrature.hpp"

#include "dem/expect.hpp"
#include "dem/vec3.hpp"

#include <cmath>

namespace dem {
namespace {

struct Legendre {
  double value, slope;
};

/// P_n and P_n' inside (-1, 1), by the three-term recurrence.
Legendre legendre(int n, double x) {
  double before = 1.0, now = x;
  for (int k = 2; k <= n; ++k) {
    double const next = ((2 * k - 1) * x * now - (k - 1) * before) / k;
    before = now;
    now = next;
  }
  return {now, n * (x * now - before) / (x * x - 1.0)};
}

} // namespace

QuadratureRule gauss_legendre(int n) {
  EXPECT(n >= 1);
  QuadratureRule rule;
  for (int k = n; k >= 1; --k) {
    double x =
        std::cos(pi * (k - 0.25) / (n + 0.5)); // near enough for Newton to converge quadratically
    for (int iteration = 0; iteration < 8; ++iteration)
      x -= legendre(n, x).value / legendre(n, x).slope;
    double const slope = legendre(n, x).slope;
    rule.points.push_back(x);
    rule.weights.push_back(2.0 / ((1.0 - x * x) * slope * slope));
  }
  return rule;
}

} // namespace dem
