#pragma once

#include "coupling/study/batch_folder.hpp"
#include "coupling/study/study_quantities.hpp"

#include <Eigen/Core>

#include <filesystem>
#include <string>
#include <vector>

/// What came out of a study, run or read: the seam between the batch and the statistics.
namespace coupling::study {

/// One run with its results.
struct ResultRow {
  StudyRun run;
  RunState state = RunState::waiting;
  std::string reason;           ///< of a failure
  std::filesystem::path folder; ///< run folder; empty for results that were read
  StudyValues values;           ///< empty unless done
  RunEstimate estimate;         ///< zero for results that were read
  double cpu_seconds = 0.0;     ///< measured; 0: not known
  double wall_seconds = 0.0;    ///< measured; 0: not known

  bool is_done() const { return state == RunState::done; }

  /// NaN where the run is not done or does not know it.  [SI]
  double value(std::string const& quantity) const;
};

/// Matrices have one row a run that is done and belongs to the design, in the design's order.
struct ResultsTable {
  StudyFile study; ///< its factors have limits
  std::vector<ResultRow> rows;

  /// Rows of the design that are done: what the matrices' rows are.
  std::vector<std::size_t> finished() const;

  /// Rows beside the design that are done.
  std::vector<std::size_t> validation() const;

  /// [SI], n_finished x n_factors.
  Eigen::MatrixXd natural() const;

  /// [1], n_finished x n_factors; low is -1, high 1.
  Eigen::MatrixXd coded() const;

  /// [SI], n_finished. @throws dem::InvalidInput if a finished run lacks the quantity
  Eigen::VectorXd response(StudyResponse const& response) const;

  /// Which replicate of its point each finished run is, from 1.
  std::vector<int> replicates() const;

  /// Processor seconds of each finished run, n_finished; NaN where it is not known.
  Eigen::VectorXd cpu_seconds() const;
};

/// The results of a study that reads them. @throws dem::InvalidInput
ResultsTable results_as_data(StudyPlan const& plan);

/// The results that stand in a study's folder, of runs of the design and beside it.
/// @param runs  in the folder, those of the plan first
ResultsTable results_of(StudyPlan const& plan, std::vector<StudyRun> const& runs,
                        std::vector<RunEstimate> const& estimates, BatchFolder const& folder);

/// A study in a folder as it stands, from its `study.resolved.prm`; runs beside the design too.
/// @throws dem::InvalidInput if there is none
ResultsTable load_study(std::filesystem::path const& folder);

/// One row a run: run, setup, replicate, role, status, each factor natural and coded, each number
/// of its summary. A table that `presscheck study` and `presscheck compare` can read.
std::string results_csv(ResultsTable const& table);

/// Writes results.csv and study.json.
/// @throws dem::InvalidInput, WriteFailed
void write_results(ResultsTable const& table, std::filesystem::path const& folder);

} // namespace coupling::study
