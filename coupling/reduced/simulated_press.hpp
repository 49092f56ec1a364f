#pragma once

#include "coupling/case.hpp"
#include "coupling/measured/measured_data.hpp"
#include "coupling/reduced/bed_fit.hpp"
#include "coupling/reduced/press_model.hpp"

#include <filesystem>

namespace coupling::reduced {

/// A simulation of a case, as an emulator that stands for it.
struct SimulatedPress {
  Press nominal; ///< with the case's own machine
  Sheet sheet;
  BedFit fit;
};

/// The law of the bed that a run folder holds: case.resolved.prm, curves.csv, and the grains of
/// run.h5 for the volume of the solid (without it the case's masses over densities).
/// @throws dem::InvalidInput if something is missing or is no press cycle
SimulatedPress simulated_press(std::filesystem::path const& run_folder);

/// The same bed with the laboratory's mass of the same powder in the laboratory's die.
Press in_laboratory(SimulatedPress const& simulated, measured::Sample const& sample);

/// How well the emulator stands for its simulation, in a sentence.
std::string in_words(BedFit const& fit);

/// Volume of the solid of a powder over its mass, sum of w_i / rho_i [m^3/kg].
double specific_volume(Powder const& powder);

} // namespace coupling::reduced
