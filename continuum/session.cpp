#include "continuum/session.hpp"

#include "continuum/expect.hpp"
#include "continuum/ranks.hpp"
#include "continuum/tool/help.hpp"

#include <deal.II/base/multithread_info.h>

#include <petscsys.h>

#include <csignal>
#include <cstdlib>

namespace continuum {

namespace {
enum class State { before, active, over };
State state = State::before;

void start(PetscErrorCode code) {
  if (code != 0)
    throw SolverFailure("PETSc does not start (error " + std::to_string(code) +
                        "). Is Open MPI installed and allowed to run here?");
}
} // namespace

Session::Session() {
  VALIDATE(state == State::before,
           "a second continuum::Session (MPI starts once per process). Keep the first one alive?");
  start(PetscOptionsSetValue(nullptr, "-no_signal_handler", "true"));
  start(PetscOptionsSetValue(nullptr, "-skip_petscrc", "true"));
  start(PetscInitializeNoArguments());
  // Codes are checked at every call and thrown; the default handler would print a stack as well.
  start(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
  dealii::MultithreadInfo::set_thread_limit(1);
  ranks::open();
  state = State::active;
}

Session::~Session() {
  state = State::over;
  ranks::close();
  PetscFinalize();
}

bool Session::is_active() {
  return state == State::active;
}

int Session::n_ranks() {
  return ranks::count();
}

bool Session::is_helper() {
  return !ranks::is_first();
}

void Session::help() {
  // mpirun passes them to every rank; the first writes a restart and ends all, or is ended itself.
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  help_with_tools();
}

int n_started_processes() {
  // Of Open MPI, and of the starters of MPICH and of batch systems.
  for (char const* const name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (char const* const value = std::getenv(name))
      return std::atoi(value);
  return std::getenv("PMIX_RANK") ? 1 : 0;
}

} // namespace continuum
