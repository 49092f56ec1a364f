#pragma once

#include "coupling/verification/verify.hpp"

#include <functional>
#include <string>
#include <vector>

namespace coupling::verification {

/// A benchmark that can be run: one calculation may answer several questions, hence several rows.
struct Experiment {
  std::string name; ///< theme/subject; the rows' names start with it
  std::function<std::vector<Benchmark>()> run;
};

// One function a theme, one file a function. To add a benchmark, add an entry to its theme's list;
// to add a theme, add a line here and in all_experiments().
std::vector<Experiment> collision_experiments();
std::vector<Experiment> adhesion_experiments();
std::vector<Experiment> friction_experiments();
std::vector<Experiment> integrator_experiments();
std::vector<Experiment> particle_impact_experiments();
std::vector<Experiment> press_motion_experiments();
std::vector<Experiment> study_experiments();
// Finite elements: MPI and PETSc start with the first run.
std::vector<Experiment> elasticity_experiments();
std::vector<Experiment> coupled_experiments();

std::vector<Experiment> all_experiments();

/// Those that can have rows for a filter: with the filter in their name, or whose name it starts
/// with; if there are none, those of the theme that it starts with. The others do not run.
std::vector<Experiment> experiments_for(std::string_view filter);

} // namespace coupling::verification
