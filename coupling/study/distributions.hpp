#pragma once

/// The four distributions of the study. Degrees of freedom that are not there (0 or less) and
/// values that are no numbers give NaN.
namespace coupling::study {

/// P(|t| >= |value|) of Student's t.
double student_p(double value, double df);

/// t such that P(|t| <= quantile) = confidence.
double student_quantile(double confidence, double df);

/// P(F >= value).
double fisher_p(double value, double df_numerator, double df_denominator);

/// P(chi^2 >= value).
double chi_squared_p(double value, double df);

/// q such that P(chi^2 <= q) = confidence.
double chi_squared_quantile(double confidence, double df);

/// z such that P(|z| <= quantile) = confidence.
double normal_quantile(double confidence);

} // namespace coupling::study
