#pragma once

#include "coupling/reduced/grain_effects.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace coupling::reduced {

/// The mean of a plastic powder's changes over packing seeds, with standard errors.
struct PlasticEffect {
  double yield_pressure; ///< of the contacts [Pa]
  std::size_t n_seeds;
  PlasticChange mean, error;
};

/// What a library of runs says: one factor at a time around one case, several packing seeds.
struct GrainLibrary {
  std::vector<GrainEffect> effects;
  std::vector<PlasticEffect> plastic; ///< by falling yield pressure
  BedLaw middle;             ///< numbers of the case in the middle, mean over seeds; no tables
  BedNumbers middle_error{}; ///< standard deviation of a seed
  std::size_t n_runs = 0;
};

/// Reads the runs of a study's folder. The setup `base` is the middle; of each other run the case
/// tells which factor it changes.
/// @throws dem::InvalidInput for a run that changes none or two
GrainLibrary read_library(std::filesystem::path const& study);

/// The table as JSON, with units, source and command.
std::string library_json(GrainLibrary const& library, std::string const& command);

/// Effects of a table that library_json wrote. @throws dem::InvalidInput, with the file's name
std::vector<GrainEffect> read_effects(std::filesystem::path const& file);

} // namespace coupling::reduced
