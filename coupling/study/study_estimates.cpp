#include "coupling/study/study_estimates.hpp"

namespace coupling::study {

std::vector<RunEstimate> estimate_runs(std::vector<StudyRun> const& runs,
                                       BatchFolder const& folder) {
  auto const kept = folder.kept_estimates(runs);
  std::vector<RunEstimate> estimates;
  double seconds = 0.0, particle_steps = 0.0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    estimates.push_back(kept[k] ? *kept[k] : estimate_run(runs[k]));
    auto const record = folder.record(runs[k]);
    if (record.state != RunState::done)
      continue;
    seconds += record.cpu_seconds;
    particle_steps += estimates[k].particle_steps();
  }
  if (particle_steps > 0.0)
    for (auto& estimate : estimates)
      estimate.seconds_per_particle_step = seconds / particle_steps;
  return estimates;
}

} // namespace coupling::study
