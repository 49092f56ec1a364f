#include "coupling/study/distributions.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <cmath>
#include <limits>

namespace coupling::study {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// P(X >= value); Boost refuses infinity, which a fit without residuals has.
double upper_tail(auto const& distribution, double value) {
  if (std::isnan(value))
    return unknown;
  return std::isinf(value) ? 0.0 : cdf(complement(distribution, value));
}

} // namespace

double student_p(double value, double df) {
  return df > 0.0 ? 2.0 * upper_tail(boost::math::students_t(df), std::abs(value)) : unknown;
}

double student_quantile(double confidence, double df) {
  return df > 0.0 ? quantile(complement(boost::math::students_t(df), 0.5 * (1.0 - confidence)))
                  : unknown;
}

double fisher_p(double value, double df_numerator, double df_denominator) {
  if (!(df_numerator > 0.0 && df_denominator > 0.0))
    return unknown;
  return upper_tail(boost::math::fisher_f(df_numerator, df_denominator), value);
}

double chi_squared_p(double value, double df) {
  return df > 0.0 ? upper_tail(boost::math::chi_squared(df), value) : unknown;
}

double chi_squared_quantile(double confidence, double df) {
  return df > 0.0 ? quantile(boost::math::chi_squared(df), confidence) : unknown;
}

double normal_quantile(double confidence) {
  return quantile(complement(boost::math::normal(), 0.5 * (1.0 - confidence)));
}

} // namespace coupling::study
