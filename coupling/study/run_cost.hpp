#pragma once

#include "coupling/study/study_plan.hpp"

#include <string>
#include <vector>

namespace coupling::study {

/// The program, its libraries and what it writes pictures with, measured.
inline constexpr double bytes_of_program = 200e6;

/// Memory of a run:  200 MB + 1000 B a grain (run_estimate.hpp: what the engine is allowed).  [B]
double bytes_of_run(double grains);

/// What a run is expected to need.
struct RunEstimate {
  double grains = 0.0;
  double steps = 0.0;
  double bytes = 0.0;                     ///< of memory, the program included
  double seconds_per_particle_step = 0.0; ///< of one processor

  double particle_steps() const { return grains * steps; }
  double cpu_seconds() const { return particle_steps() * seconds_per_particle_step; }
};

/// Builds a run's press as `presscheck check` does, with rigid tools, and measures a few of its
/// steps.
/// @throws dem::InvalidInput for what only the geometry can refuse, naming the run
RunEstimate estimate_run(StudyRun const& run);

/// Sums of all runs.
struct StudyCost {
  std::size_t n_runs = 0;
  double particle_steps = 0.0;
  double cpu_seconds = 0.0;
  double largest_bytes = 0.0;
  double longest_cpu_seconds = 0.0;
};

StudyCost sum_costs(std::vector<RunEstimate> const& estimates);

/// A table of the runs with their sizes, and the sums, as text.
std::string describe_costs(std::vector<StudyRun> const& runs,
                           std::vector<RunEstimate> const& estimates);

} // namespace coupling::study
