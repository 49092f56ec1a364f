#pragma once

#include "coupling/record/h5.hpp"

#include <string>

namespace coupling {

/// Refuses grains that cannot be grains: arrays of different lengths, positions, velocities or
/// spins that are not finite, radii or masses that are not positive, ids that are not 0 .. n - 1
/// each once.
/// @param folder  of the datasets in the file, "state/grains/"
/// @throws dem::InvalidInput
void check_grains(H5Reader const& file, std::string const& folder);

} // namespace coupling
