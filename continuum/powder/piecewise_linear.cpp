#include "continuum/powder/piecewise_linear.hpp"

#include "continuum/expect.hpp"
#include "continuum/tool/quote.hpp"

namespace continuum {

void PiecewiseLinear::validate(std::string const& name, std::string const& abscissa) const {
  VALIDATE(!rows.empty(), name + ": the table has no row (a property has a value somewhere). Give "
                                 "one row for a constant?");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    VALIDATE(std::isfinite(rows[i].x) && std::isfinite(rows[i].value),
             name + ": row " + std::to_string(i + 1) + " = (" + quote(rows[i].x) + ", " +
                 quote(rows[i].value) + ") (numbers are finite). Is a value missing?");
    VALIDATE(i == 0 || rows[i].x > rows[i - 1].x,
             name + ": row " + std::to_string(i + 1) + " at " + abscissa + " = " +
                 quote(rows[i].x) + " does not follow " + quote(rows[i - 1].x) +
                 " (rows ascend strictly, or no value lies between them). Sort the rows?");
  }
}

double PiecewiseLinear::smallest() const {
  return std::ranges::min(rows, {}, &Row::value).value;
}

double PiecewiseLinear::largest() const {
  return std::ranges::max(rows, {}, &Row::value).value;
}

bool PiecewiseLinear::is_ascending() const {
  return std::ranges::is_sorted(rows, {}, &Row::value);
}

} // namespace continuum
