#pragma once

#include <filesystem>
#include <vector>

namespace hidden {

/// One record of a simulated press: what is true, before machine and gauges.
struct Pressed {
  double height;       ///< between the punch faces [m]
  double upper, lower; ///< forces on the punches [N]
  double radial;       ///< mean pressure on the wall of the die [Pa]
};

/// A press cycle of grains without a dwell.
struct Curve {
  std::vector<Pressed> loading, unloading; ///< in time's order, heights falling and rising
  double compact_height = 0.0;             ///< of the released compact [m], 0 if not recorded
  double peak() const;                     ///< largest upper force [N]
};

/// Mean of curves at the heights of the first.
Curve mean_of(std::vector<Curve> const& curves);

/// The grains' modulus, their cohesion and the tools' modulus times a factor: forces alone grow, by
/// that factor (no rate, no weight).
Curve scaled(Curve curve, double factor);

/// curves.csv of a run folder of presscheck (outward contract, section 4), as text: nothing of the
/// project's own readers is used.
/// @throws std::runtime_error if a column is missing or a number is none
Curve read_run(std::filesystem::path const& folder);

/// What deck_of (peer.hpp) has the other code write: time, height, upper, lower, force on the wall
/// outwards, one record a line.
/// @param bore  [m], to make a pressure of that force
Curve read_peer(std::filesystem::path const& file, double bore);

} // namespace hidden
