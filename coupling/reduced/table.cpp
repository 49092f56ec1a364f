#include "coupling/reduced/table.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace coupling::reduced {
namespace {

double secant(Table const& table, std::size_t k) {
  return (table.values[k + 1] - table.values[k]) / (table.knots[k + 1] - table.knots[k]);
}

/// Slope at a knot: weighted harmonic mean of the secants beside it, none at a turn; at an end that
/// of the secant.
double slope(Table const& table, std::size_t k) {
  std::size_t const last = table.knots.size() - 1;
  if (k == 0 || k == last)
    return secant(table, k == 0 ? 0 : last - 1);
  double const before = secant(table, k - 1), after = secant(table, k);
  if (!(before * after > 0.0))
    return 0.0;
  double const left = table.knots[k] - table.knots[k - 1];
  double const right = table.knots[k + 1] - table.knots[k];
  double const w_before = left + 2.0 * right, w_after = 2.0 * left + right;
  return (w_before + w_after) / (w_before / before + w_after / after);
}

} // namespace

double Table::at(double x) const {
  EXPECT(!empty());
  if (!(x > knots.front()))
    return values.front();
  if (x >= knots.back())
    return values.back();
  auto const k = static_cast<std::size_t>(std::ranges::upper_bound(knots, x) - knots.begin()) - 1;
  double const width = knots[k + 1] - knots[k], t = (x - knots[k]) / width;
  double const rise = values[k + 1] - values[k];
  double const start = width * slope(*this, k), end = width * slope(*this, k + 1);
  // Hermite's cubic: v + t start + t^2 (3 rise - 2 start - end) + t^3 (start + end - 2 rise)
  return values[k] +
         t * (start + t * (3.0 * rise - 2.0 * start - end + t * (start + end - 2.0 * rise)));
}

void validate(Table const& table, std::string const& name) {
  VALIDATE(table.knots.size() == table.values.size(),
           fmt::format("table {}: {} knots and {} values. One value for each knot?", name,
                       table.knots.size(), table.values.size()));
  VALIDATE(std::ranges::all_of(table.knots, [](double x) { return std::isfinite(x); }) &&
               std::ranges::all_of(table.values, [](double y) { return std::isfinite(y); }),
           fmt::format("table {}: holds a number that is not finite. Is a record missing?", name));
  VALIDATE(std::ranges::adjacent_find(table.knots, std::greater_equal<>()) == table.knots.end(),
           fmt::format("table {}: knots do not increase. Are two swapped?", name));
}

} // namespace coupling::reduced
