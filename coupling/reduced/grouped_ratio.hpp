#pragma once

#include "coupling/reduced/table.hpp"

#include <optional>
#include <vector>

namespace coupling::reduced {

/// A noisy ratio along a curve as a table: points are gathered in groups of neighbours of equal
/// number, each a knot at its mean x (weighed with the denominator), with the value
///   sum of numerators / sum of denominators.
class GroupedRatio {
public:
  /// @param x  rising or falling from call to call; @param denominator  >= 0
  void add(double x, double numerator, double denominator = 1.0);

  /// @param from, to  places at which the table is 0 whatever the points say, outside of them
  /// @return empty if there is no point
  Table table(std::size_t most_groups, std::optional<double> from = {},
              std::optional<double> to = {}) const;

private:
  struct Point {
    double x, numerator, denominator;
  };
  std::vector<Point> points_;
};

} // namespace coupling::reduced
