#pragma once

namespace coupling {

/// MPI and PETSc for this process, from the first call until the program ends: only who deforms
/// tools pays for them. Does nothing where a continuum::Session is alive already.
/// @throws continuum::SolverFailure if they do not start
void ensure_session();

} // namespace coupling
