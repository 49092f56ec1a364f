#pragma once

#include "dem/packing/grain_counts.hpp"
#include "dem/packing/packing.hpp"
#include "dem/packing/relax_overlaps.hpp"

#include <cstdint>
#include <span>

namespace dem {

/// Fills a cylinder at random with grains that touch neither each other nor a wall, all at rest.
/// Random sequential insertion, largest first, components of one size in random order; where no
/// free place is found in 2000 tries, a grain takes the least crowded of its places and
/// relax_overlaps makes room at the end. The clearance is packing_clearance of the radii. The same
/// seed gives the same bits.
/// @param classes  any order; count 0 is allowed
/// @returns        grains, largest first
/// @throws InvalidInput if a grain does not fit the cylinder, or all of them do not (about 55 %
/// solid can be reached) Source: Widom, J. Chem. Phys. 44 (1966) 3888 (random sequential addition).
Packing fill_cylinder(std::span<GrainClass const> classes, FillVolume const& volume,
                      std::uint64_t seed);

} // namespace dem
