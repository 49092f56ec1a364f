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

std::vector<Experiment> all_experiments();

} // namespace coupling::verification
