#pragma once

#include "coupling/measured/measured_data.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace coupling::measured {

/// A reading and its place in the series.
struct Reading {
  double value;
  std::size_t place;
};

/// @return  nothing if all readings are gaps
std::optional<Reading> smallest_of(std::span<double const> values);
std::optional<Reading> largest_of(std::span<double const> values);

/// How fast a gap closed, by the times at which it had done 10 % and 90 % of its way from the first
/// reading (or the fill height, if that is less) to the smallest, each interpolated between two
/// readings.
struct Closing {
  double speed;    ///< [m/s]
  double duration; ///< [s], between the two times
  double way;      ///< [m], between the two gaps
};

/// @return  nothing with fewer than three readings in between: then there is no speed to speak of
std::optional<Closing> closing_of(Run const& run);

} // namespace coupling::measured
