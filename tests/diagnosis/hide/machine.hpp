#pragma once

#include "tests/diagnosis/hide/press.hpp"

#include <span>

namespace hidden {

/// Gap between the faces less the commanded one, without force [m].
double gap_error(Effects const& effects, Protocol const& protocol, double time);

/// What frame and tools give way [m]: seats settle under the first kilonewtons.
double frame_travel(Effects const& effects, double force);

/// Bore where the bed stands [m]: worn most below the mouth.
double bore_at(Effects const& effects, double height);

/// Factor on the bed's stresses from its rate: a power of it, hyperbolic relaxation in a dwell,
/// turning round over a tenth of a millimetre as the press opens.
double rate_factor(Effects const& effects, Protocol const& protocol, double time);

/// The load cell and the guides of the upper punch: true force to reading, lag last.
void show_upper_force(Effects const& effects, Protocol const& protocol, std::span<Moment> moments);

} // namespace hidden
