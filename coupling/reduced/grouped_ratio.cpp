#include "coupling/reduced/grouped_ratio.hpp"

#include <algorithm>

namespace coupling::reduced {

void GroupedRatio::add(double x, double numerator, double denominator) {
  points_.push_back({x, numerator, denominator});
}

Table GroupedRatio::table(std::size_t most_groups, std::optional<double> from,
                          std::optional<double> to) const {
  auto points = points_;
  std::ranges::stable_sort(points, {}, &Point::x);
  std::size_t const n = points.size(), n_groups = std::min(n, most_groups);
  Table table;
  auto const add_knot = [&](double x, double value) {
    if (table.empty() || x > table.knots.back())
      table.knots.push_back(x), table.values.push_back(value);
  };
  if (from)
    add_knot(*from, 0.0);
  for (std::size_t group = 0; group < n_groups; ++group) {
    Point sum{0.0, 0.0, 0.0};
    for (std::size_t k = group * n / n_groups; k < (group + 1) * n / n_groups; ++k) {
      sum.x += points[k].denominator * points[k].x;
      sum.numerator += points[k].numerator;
      sum.denominator += points[k].denominator;
    }
    if (!(sum.denominator > 0.0))
      continue;
    double const x = sum.x / sum.denominator;
    if (!to || x < *to)
      add_knot(x, sum.numerator / sum.denominator);
  }
  if (to)
    add_knot(*to, 0.0);
  return table;
}

} // namespace coupling::reduced
