#pragma once

#include "continuum/powder/dual.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace continuum {

/// A table, linear between its rows and constant beyond its ends (Abaqus' convention for field
/// variables). One row is a constant.
struct PiecewiseLinear {
  struct Row {
    double x, value;
  };
  std::vector<Row> rows; ///< x ascending, at least one

  PiecewiseLinear() = default;
  // A constant property is written as its number.
  // NOLINTNEXTLINE(google-explicit-constructor)
  PiecewiseLinear(double constant) : rows{{0.0, constant}} {}
  PiecewiseLinear(std::initializer_list<Row> list) : rows(list) {}
  explicit PiecewiseLinear(std::vector<Row> list) : rows(std::move(list)) {}

  /// Value at x; T is double or a Dual.
  template <class T> T operator()(T const& x) const {
    auto const after = std::upper_bound(rows.begin(), rows.end(), value_of(x),
                                        [](double at, Row const& row) { return at < row.x; });
    if (after == rows.begin())
      return T(rows.front().value);
    if (after == rows.end())
      return T(rows.back().value);
    Row const& low = *(after - 1);
    return low.value + (after->value - low.value) / (after->x - low.x) * (x - low.x);
  }

  /// @param name      what messages call the table
  /// @param abscissa  what they call x
  /// @throws InvalidInput without a row, for values that are not finite, and for rows whose x does
  ///         not ascend
  void validate(std::string const& name, std::string const& abscissa) const;

  double smallest() const;   ///< of the values
  double largest() const;    ///< of the values
  bool is_ascending() const; ///< values never fall
};

} // namespace continuum
