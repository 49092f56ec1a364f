#pragma once

#include "coupling/diagnosis/observations.hpp"

#include <string>
#include <vector>

namespace coupling::diagnosis {

/// Rows that are tested together: all blocks of a channel and phase, or of a run and channel.
struct Cell {
  std::string label;
  std::vector<std::size_t> blocks;
};

std::vector<Cell> cells_by_phase(Observations const& observations); ///< channel x phase
std::vector<Cell> cells_by_run(Observations const& observations);   ///< run x channel

/// Statistics of one cell for many residuals at once, each a row of `values` that is large when
/// something is wrong; `contrasts` are the signed ones (level, slope, curvature), N(0, 1) before
/// calibration.
struct CellStatistics {
  std::vector<std::string> names; ///< of the rows of `values`
  Eigen::MatrixXd values;         ///< n_statistics x n_residuals
  Eigen::MatrixXd contrasts;      ///< 3 x n_residuals
};

/// Sum of squares e' C^-1 e with C the covariance of the cell's rows; runs and Ljung-Box of blocks
/// with at least 8 rows, each whitened by its own covariance; contrasts q' C^-1 e / sqrt(q' C^-1
/// q), q_i = sd_i times 1, 2 s - 1 and 6 s (s - 1) + 1 of the phase coordinate, squared.
/// @param residuals  y - b - f, n_rows x n_residuals
CellStatistics cell_statistics(Observations const& observations, Cell const& cell,
                               Eigen::MatrixXd const& covariance, Eigen::MatrixXd const& residuals);

/// The level contrast alone: values has one row, "offset".
CellStatistics level_statistics(Observations const& observations, Cell const& cell,
                                Eigen::MatrixXd const& covariance,
                                Eigen::MatrixXd const& residuals);

} // namespace coupling::diagnosis
