#pragma once

#include "coupling/progress.hpp"
#include "coupling/study/batch_folder.hpp"

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace coupling::study {

struct BatchOptions {
  int jobs = 1;              ///< runs at once
  int threads = 1;           ///< of each run
  bool retries = false;      ///< try failed runs again
  bool waits = true;         ///< for runs that another process works at
  std::size_t first = 0;     ///< where in the list this process starts looking: its rank
  std::function<int()> stop; ///< the signal that asks to stop; 0 while there is none
  ProgressStyle style = ProgressStyle::lines;
};

struct BatchOutcome {
  std::size_t n_done = 0;
  std::size_t n_failed = 0;
  std::size_t n_stopped = 0; ///< interrupted: they go on from their restarts
  std::size_t n_waiting = 0;
  bool is_interrupted = false;

  bool is_complete() const { return n_failed + n_stopped + n_waiting == 0; }
};

/// Runs what is not done yet, each run in a process of its own. A run that was interrupted goes on
/// from its newest restart. Any number of processes may work at the same folder: the locks see to
/// it that no run is run twice.
/// @param runs       prepared in the folder
/// @param estimates  one a run, for the time left
/// @param out        for progress
BatchOutcome run_batch(BatchFolder const& folder, std::vector<StudyRun> const& runs,
                       std::vector<RunEstimate> const& estimates, BatchOptions const& options,
                       std::ostream& out);

/// How the runs stand at this moment.
BatchOutcome count_runs(BatchFolder const& folder, std::vector<StudyRun> const& runs);

} // namespace coupling::study
