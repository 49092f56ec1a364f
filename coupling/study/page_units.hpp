#pragma once

#include "coupling/study/results_table.hpp"

#include <span>
#include <string>

namespace coupling::study {

/// In what unit a page shows a column of numbers:  shown = SI x factor.
struct ShownUnit {
  double factor = 1.0;
  std::string text; ///< "kN", "%"; empty for a bare number

  /// `F [kN]`
  std::string head(std::string const& name) const {
    return text.empty() ? name : name + " [" + text + "]";
  }
};

/// Per cent for ratios that people say so (porosities, springback), else the prefix with which the
/// largest of the response's numbers reads between 1 and 1000.
ShownUnit shown_unit(ResultsTable const& table, StudyResponse const& response);

/// As the study's author writes the factor.
ShownUnit shown_unit(StudyFactor const& factor);

/// Up to so many significant digits without trailing zeros; an exponent only below 1e-4 and from
/// 1e7 on; "-" for NaN.
std::string short_number(double value, int digits = 5);

/// Decimals with which the largest of a column's numbers has so many digits; none where all are
/// whole numbers.
int decimals_of(std::span<double const> column, int digits = 5);

/// With so many decimals; "-" for NaN.
std::string fixed_number(double value, int decimals);

/// `1878 MPa`: a factor's value to four digits.
std::string short_text(StudyFactor const& factor, double natural);

/// `13.4 s`, `5.1 min`, `3.2 h`, `12.5 days`, `3.8 years`; "not known" for NaN.
std::string duration_text(double seconds);

} // namespace coupling::study
