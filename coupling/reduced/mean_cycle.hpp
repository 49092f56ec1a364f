#pragma once

#include "coupling/reduced/simulated_cycle.hpp"

#include <span>

namespace coupling::reduced {

/// The mean of cycles of the same programme, other packings: forces and pressure at the heights
/// which the first passes in loading and unloading, each cycle's interpolated between its records.
/// One cycle is its own mean, to the bit.
/// @throws dem::InvalidInput as parts_of, and for turns further apart than a thousandth of the
/// height: those were other programmes
SimulatedCycle mean_cycle(std::span<SimulatedCycle const> cycles);

} // namespace coupling::reduced
