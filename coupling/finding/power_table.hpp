#pragma once

#include "coupling/diagnosis/power.hpp"
#include "coupling/finding/finding_parts.hpp"
#include "coupling/reduced/instrument_sets.hpp"
#include "coupling/reduced/simulated_press.hpp"

namespace coupling::finding {

/// One set of instruments and what it shows.
struct PowerColumn {
  reduced::InstrumentSet set;
  Eigen::Index n_rows;
  std::vector<diagnosis::Power> causes; ///< in the same order in all columns
};

/// Which instruments a laboratory must have to see what.
struct PowerTable {
  Provenance provenance; ///< without measured data
  std::string emulator;  ///< how well it stands for its simulation, a sentence
  reduced::Instruments instruments;
  diagnosis::PowerSettings settings;
  std::vector<diagnosis::CalibratedParameter> calibrated;
  std::vector<diagnosis::Scatter> scatters;
  std::vector<StatedError> tolerances;
  std::vector<PowerColumn> columns;
};

/// What is asked: the press as it should be, and what would be read of it.
struct PowerQuestion {
  reduced::SimulatedPress const& simulated;
  reduced::Press const& nominal; ///< with the mass and die of the laboratory
  double fill_height;            ///< [m]
  reduced::Instruments instruments = {};
  diagnosis::PowerSettings settings = {};
};

/// @throws dem::InvalidInput as planned_rows and power_of do
PowerTable power_table(PowerQuestion const& question,
                       std::vector<reduced::InstrumentSet> const& sets);

/// Everything, SI units; null where no size is.
std::string power_json(PowerTable const& table);

/// The table for a README, sizes in the units of a press: `0.36 / 0.58 (force_lag)`, detected and
/// told apart, the rival where the second costs more; a dash where no size within the range is.
std::string power_markdown(PowerTable const& table);

/// The same for a terminal; a rival is the number of its line.
std::string power_text(PowerTable const& table);

} // namespace coupling::finding
