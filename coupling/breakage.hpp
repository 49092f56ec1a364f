#pragma once

#include "coupling/press.hpp"

namespace coupling {

/// Largest normal force of a contact on each grain over the square of its diameter [Pa], by row.
std::vector<double> largest_stress(dem::World const& world);

/// Steps between two looks at the grains: a contact force grows over some hundred steps.
inline constexpr std::uint64_t breakage_interval = 50;

/// Crushes the grains that have reached their strength (see BreakageLaw, dem::crush). The ledger
/// books the energy that their contacts, motion and dust held, the momentum its dust's. The plan of
/// steps is renewed: fragments are fast.
void break_grains(Press& press);

} // namespace coupling
