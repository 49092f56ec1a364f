#pragma once

#include "coupling/press.hpp"

#include <filesystem>

namespace coupling {

/// Builds a press from a case: materials, tools (read or generated), grains, programme; everything
/// that only geometry can validate is validated here. Forces are computed, nothing has moved.
///  - z = 0 is the lower punch face, x = y = 0 the die's axis; the upper punch starts at the fill
///  height.
///  - materials: one row per component of the powder, then the tools'.
///  - a settling time becomes a first stage `settle`.
/// @throws dem::InvalidInput
Press set_up_press(Case const& setup);

/// The same with the state of a restart file instead of a filling.
/// @throws dem::InvalidInput if the file is not whole or not of this case
Press restore_press(Case const& setup, std::filesystem::path const& restart_file);

/// The stages that will run: the case's, after settling.
std::vector<Stage> stages_of(Case const& setup);

/// The longest time step that the case allows in a state: a fraction of the Rayleigh time, or,
/// adaptive, a fraction of the stable step, at most 20 % of the Rayleigh time (first touch is not
/// resolved beyond).
PressProgramme::LongestStep longest_step_of(TimeStepping const& time_stepping);

/// Writes the tools' surfaces as binary STL into `folder`; analytic walls have none.
/// @throws dem::InvalidInput, WriteFailed
void write_tools(Press const& press, std::filesystem::path const& folder);

} // namespace coupling
