#pragma once

namespace continuum {

/// MPI and PETSc for this process, alive as long as the object: make one at the start of `main`,
/// before the first ElasticTool. deal.II is held to one thread, since the grains own the cores.
/// PETSc's signal handler, options file and command line are left out, so that nothing outside the
/// case changes a result. MPI can be started once per process only, so there is one Session in the
/// life of a program.
///
/// Under `mpirun -n N` the first rank is the program, and the tools use all ranks:
///
///     continuum::Session const session;
///     if (continuum::Session::is_helper())
///       return continuum::Session::help(), 0;
///
/// The end of the first rank's Session, on whichever way out of `main`, ends the helpers' `help`.
class Session {
public:
  /// @throws InvalidInput if there is, or was, another Session
  /// @throws SolverFailure if MPI or PETSc do not start
  Session();
  ~Session();
  Session(Session const&) = delete;
  Session& operator=(Session const&) = delete;

  static bool is_active();
  static int n_ranks();    ///< 1 without mpirun, and without a Session
  static bool is_helper(); ///< true on every rank but the first

  /// For helpers: takes part in what the first rank's tools ask for until its Session ends. SIGINT
  /// and SIGTERM are left to the first rank. A helper without work sleeps.
  static void help();
};

/// How many processes mpirun (or another starter) says that it started, this one included; 0 if
/// none did. Told by the environment, so before a Session: a program that can do without one asks
/// this first.
int n_started_processes();

} // namespace continuum
