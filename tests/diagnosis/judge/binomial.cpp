#include "tests/diagnosis/judge/binomial.hpp"

#include <boost/math/distributions/binomial.hpp>

namespace judging {

int most_allowed(int n, double target, double level) {
  boost::math::binomial const law(n, target);
  int k = 0;
  while (k < n && boost::math::cdf(boost::math::complement(law, k)) >= level)
    ++k; // P(X >= k + 1) is still likely
  return k;
}

int least_allowed(int n, double target, double level) {
  boost::math::binomial const law(n, target);
  int k = 0;
  while (k < n && boost::math::cdf(law, k) < level)
    ++k;
  return k;
}

} // namespace judging
