#include "coupling/diagnosis/cell_statistics.hpp"

#include "coupling/diagnosis/series_tests.hpp"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index least_series = 8; // rows below which a series has no structure to test
constexpr int ljung_box_lags = 4;

std::vector<Index> rows_of(Observations const& observations,
                           std::vector<std::size_t> const& blocks) {
  std::vector<Index> rows;
  for (auto const b : blocks)
    for (Index k = 0; k < observations.rows()[b].n; ++k)
      rows.push_back(observations.rows()[b].first + k);
  return rows;
}

MatrixXd whitened(MatrixXd const& covariance, std::vector<Index> const& rows, MatrixXd const& of) {
  Eigen::LLT<MatrixXd> const factor(covariance(rows, rows));
  return factor.matrixL().solve(of);
}

/// Level, slope and curvature over the coordinate, in units of each row's standard deviation.
MatrixXd contrast_shapes(Observations const& observations, Cell const& cell,
                         MatrixXd const& covariance) {
  std::vector<Index> const rows = rows_of(observations, cell.blocks);
  MatrixXd shapes(static_cast<Index>(rows.size()), 3);
  Index row = 0;
  for (auto const b : cell.blocks)
    for (double const s : observations.blocks()[b].coordinate) {
      double const sd = std::sqrt(
          covariance(rows[static_cast<std::size_t>(row)], rows[static_cast<std::size_t>(row)]));
      shapes.row(row++) << sd, sd * (2.0 * s - 1.0), sd * (6.0 * s * (s - 1.0) + 1.0);
    }
  return shapes;
}

std::vector<Cell> cells_with(Observations const& observations, auto const& label) {
  std::vector<Cell> cells;
  for (std::size_t b = 0; b < observations.blocks().size(); ++b) {
    std::string const name = label(observations.blocks()[b]);
    auto found = std::ranges::find(cells, name, &Cell::label);
    if (found == cells.end())
      found = cells.insert(cells.end(), {name, {}});
    found->blocks.push_back(b);
  }
  return cells;
}

/// Runs and Ljung-Box over the blocks of a cell, two rows.
MatrixXd structure(Observations const& observations, Cell const& cell, MatrixXd const& covariance,
                   MatrixXd const& residuals) {
  auto const n = residuals.cols();
  VectorXd excess = VectorXd::Zero(n), variance = VectorXd::Zero(n), Q = VectorXd::Zero(n);
  for (auto const b : cell.blocks) {
    if (observations.rows()[b].n < least_series)
      continue;
    auto const rows = rows_of(observations, {b});
    MatrixXd const series = whitened(covariance, rows, residuals(rows, Eigen::all));
    for (Index k = 0; k < n; ++k) {
      auto const runs = count_runs(series.col(k));
      excess[k] += runs.excess;
      variance[k] += runs.variance;
      Q[k] += ljung_box(series.col(k), ljung_box_lags);
    }
  }
  MatrixXd found(2, n);
  found.row(0) = (excess.array().square() / variance.array().max(0.25)).transpose();
  found.row(1) = Q.transpose();
  return found;
}

} // namespace

std::vector<Cell> cells_by_phase(Observations const& observations) {
  return cells_with(observations, [](ChannelBlock const& block) {
    return fmt::format("{}, {}", block.channel, name_of(block.phase));
  });
}

std::vector<Cell> cells_by_run(Observations const& observations) {
  return cells_with(observations, [](ChannelBlock const& block) {
    return fmt::format("{}, {}", block.run, block.channel);
  });
}

CellStatistics cell_statistics(Observations const& observations, Cell const& cell,
                               MatrixXd const& covariance, MatrixXd const& residuals) {
  auto const rows = rows_of(observations, cell.blocks);
  auto const n_rows = static_cast<Index>(rows.size());
  Eigen::LLT<MatrixXd> const factor(covariance(rows, rows));
  MatrixXd const own = factor.matrixL().solve(MatrixXd(residuals(rows, Eigen::all)));
  MatrixXd shapes = factor.matrixL()
                        .solve(contrast_shapes(observations, cell, covariance))
                        .colwise()
                        .normalized();
  Index const n_contrasts = std::min<Index>(3, n_rows);
  CellStatistics found;
  found.contrasts = shapes.transpose() * own;
  found.names = {"sum of squares"};
  std::vector<std::string> const contrast_names{"level", "slope", "curvature"};
  bool const is_series = n_rows >= least_series;
  found.values.resize(1 + n_contrasts + (is_series ? 2 : 0), residuals.cols());
  found.values.row(0) = own.colwise().squaredNorm();
  for (Index k = 0; k < n_contrasts; ++k) {
    found.names.push_back(contrast_names[static_cast<std::size_t>(k)]);
    found.values.row(1 + k) = found.contrasts.row(k).cwiseAbs2();
  }
  if (is_series) {
    found.names.insert(found.names.end(), {"runs", "Ljung-Box"});
    found.values.bottomRows(2) = structure(observations, cell, covariance, residuals);
  }
  return found;
}

CellStatistics level_statistics(Observations const& observations, Cell const& cell,
                                MatrixXd const& covariance, MatrixXd const& residuals) {
  auto const rows = rows_of(observations, cell.blocks);
  Eigen::LLT<MatrixXd> const factor(covariance(rows, rows));
  MatrixXd const own = factor.matrixL().solve(MatrixXd(residuals(rows, Eigen::all)));
  VectorXd const shape =
      factor.matrixL()
          .solve(VectorXd(contrast_shapes(observations, cell, covariance).col(0)))
          .normalized();
  CellStatistics found{.names = {"offset"}, .values = {}, .contrasts = shape.transpose() * own};
  found.values = found.contrasts.cwiseAbs2();
  return found;
}

} // namespace coupling::diagnosis
