#pragma once

#include "coupling/diagnosis/error_model.hpp"
#include "coupling/reduced/packing_scatter.hpp"
#include "coupling/reduced/press_model.hpp"
#include "coupling/reduced/simulated_press.hpp"

#include <string>

namespace coupling::reduced {

/// How well the numbers of a simulated bed are known, the same for all runs: what another packing
/// seed, size or time step would have made of them, standard deviations.
struct BedUncertainty {
  double onset = 0.0012;       ///< [1], as pressings scatter
  double recovery = 0.004;     ///< [1], relative
  double wall_friction = 0.02; ///< [1], relative
  double radial_ratio = 0.01;  ///< [1], relative
  /// Length over which the wall's friction turns round, relative: packings scatter by 3 %, but
  /// contacts' stiffness along the wall is no number of any sheet.
  double turn_length = 0.1;
  PackingScatter packing = {}; ///< of the bed's grains, simulated as well as pressed
  std::size_t n_packings = 1;  ///< that the simulated bed is the mean of
};

/// Of a simulation: its grains scatter as so many do, in the laboratory, too, since the case is
/// what is known of that powder. Without grains the onset alone is unsure.
BedUncertainty uncertainty_of(SimulatedPress const& simulated);

/// Of a laboratory: a cell is zeroed to a third of what one of its readings is good to; packings
/// of a known number of grains scatter as those do, which is no shift of the onset (`packing`).
RepeatScatter repeat_scatter(SimulatedPress const& simulated,
                             std::vector<diagnosis::ChannelError> const& channels);

/// What is assumed of the packings of a simulation, in a sentence.
std::string packings_in_words(SimulatedPress const& simulated);

/// Covariance of the rows of a plan at the nominal press, n_rows x n_rows: the changes by these;
/// packings, a share 1 / n_packings in all runs together and once more in each run by itself; and
/// for each row by itself what the emulator misses of its simulation (r.m.s. of its phase, the
/// largest departure just after the turn; README).
Eigen::MatrixXd numerical_covariance(PressModel const& model, BedFit const& fit,
                                     BedUncertainty const& uncertainty = {});

/// Everything that is said of errors for measured rows against the emulator of a simulation:
/// instruments as the laboratory states them; the emulator's own departure from its simulation on
/// top of the declared tolerance; what the simulation's bed is not sure of as numerical error.
diagnosis::ErrorSources error_sources(PressModel const& model,
                                      std::vector<diagnosis::ChannelError> channels,
                                      BedFit const& fit, BedUncertainty const& uncertainty = {});

} // namespace coupling::reduced
