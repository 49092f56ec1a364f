#pragma once

namespace coupling {

/// MPI and PETSc for this process, from the first call until the program ends: only who deforms
/// tools pays for them. Does nothing where a continuum::Session is alive already.
/// @throws continuum::SolverFailure if they do not start
void ensure_session();

/// To be asked at the start of `main`. Under `mpirun -n N` it starts the session; the first rank
/// gets false at once and is the program, every other helps it with its tools until the first one
/// ends, and gets true: it is to end, too. Without mpirun false, and nothing is started.
/// @throws dem::InvalidInput if MPI knows of fewer processes than were started: each would take
///                           itself for the program
bool help_first_rank();

/// Ranks that share the work of elastic tools; 1 without mpirun.
int n_ranks();

} // namespace coupling
