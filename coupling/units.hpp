#pragma once

#include "coupling/quantity.hpp"

#include <string_view>

namespace coupling {

/// A unit, or a product of powers of units, as a factor on SI:  multiplier x 10^decade.
struct Unit {
  Dimension dimension;
  int decade = 0;
  double multiplier = 1.0;
};

/// Reads `kg/m^3`, `mm/min`, `N m`, `N*m`, `%`, `1/s`. A slash divides by the one unit that follows
/// it.
/// @throws dem::InvalidInput  naming the part that is no unit, with the nearest one that is
Unit parse_unit(std::string_view text);

} // namespace coupling
