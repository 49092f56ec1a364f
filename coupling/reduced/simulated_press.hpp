#pragma once

#include "coupling/case.hpp"
#include "coupling/measured/measured_data.hpp"
#include "coupling/reduced/bed_fit.hpp"
#include "coupling/reduced/press_model.hpp"

#include <filesystem>
#include <vector>

namespace coupling::reduced {

/// A simulation of a case, or the mean of several packings of it, as an emulator.
struct SimulatedPress {
  Press nominal; ///< with the case's own machine
  Sheet sheet;
  BedFit fit;
  std::size_t n_grains = 0; ///< of one packing; 0: not known
  std::size_t n_packings = 1;
};

/// The law of the bed that a run folder holds: case.resolved.prm, curves.csv, and the grains of
/// run.h5 for the volume of the solid (without it the case's masses over densities).
/// @throws dem::InvalidInput if something is missing or is no press cycle
SimulatedPress simulated_press(std::filesystem::path const& run_folder);

/// The same of several packings: the law of their mean cycle (mean_cycle).
/// @throws dem::InvalidInput as above, for no folder, and if one is of another case
SimulatedPress simulated_press(std::vector<std::filesystem::path> const& run_folders);

/// The same bed with the laboratory's mass of the same powder in the laboratory's die.
Press in_laboratory(SimulatedPress const& simulated, measured::Sample const& sample);

/// How well the emulator stands for its simulation, in a sentence.
std::string in_words(BedFit const& fit);

/// Volume of the solid of a powder over its mass, sum of w_i / rho_i [m^3/kg].
double specific_volume(Powder const& powder);

} // namespace coupling::reduced
