#pragma once

namespace continuum {

/// MPI and PETSc for this process, alive as long as the object: make one at the start of `main`,
/// before the first ElasticTool. Serial: one rank, no `mpirun`; deal.II is held to one thread,
/// since the grains own the cores. PETSc's signal handler, options file and command line are left
/// out, so that nothing outside the case changes a result. MPI can be started once per process
/// only, so there is one Session in the life of a program.
class Session {
public:
  /// @throws InvalidInput if there is, or was, another Session
  /// @throws SolverFailure if MPI or PETSc do not start
  Session();
  ~Session();
  Session(Session const&) = delete;
  Session& operator=(Session const&) = delete;

  static bool is_active();
};

} // namespace continuum
