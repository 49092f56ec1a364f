#pragma once

#include "coupling/press.hpp"

#include <filesystem>
#include <string>

namespace coupling::commands {

struct Execution {
  std::filesystem::path folder;
  std::string until; ///< last stage to run; empty = all
  bool quiet = false;
  bool is_new = true; ///< write the inputs, too
};

/// Runs a press to its end, to a stage or to an interruption, and writes what there is to write.
/// @returns exit status
/// @throws dem::PhysicsGuard with the evidence and the last good restart
int execute(Press& press, Execution const& how);

/// Refuses a stage that the programme does not have. @throws dem::InvalidInput
void check_last_stage(Press const& press, std::string const& until);

/// Threads for all that follows; 0 leaves the choice to OpenMP.
void use_threads(int threads);

/// Says on standard error what mpirun does not do for this case: ranks that only wait, cores that
/// the grains may not use.
void note_ranks(Case const& setup);

/// The case with its overrides and its set-up's. @throws dem::InvalidInput
struct CaseChoice;
Case read_chosen_case(CaseChoice const& choice);

} // namespace coupling::commands
