#pragma once

#include <string>
#include <vector>

namespace coupling::reduced {

/// A curve that was measured: values at knots, between them the monotone cubic of Fritsch and
/// Butland (between two knots it stays between their values, its slope is continuous), beyond the
/// ends constant. Source: Fritsch, Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300.
struct Table {
  std::vector<double> knots;  ///< increasing
  std::vector<double> values; ///< as many

  bool empty() const { return knots.empty(); }
  /// @param x  any number; the table is not empty
  double at(double x) const;
};

/// @param name  for the message
/// @throws dem::InvalidInput if knots do not increase or numbers are missing or not finite
void validate(Table const& table, std::string const& name);

} // namespace coupling::reduced
