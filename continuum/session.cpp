#include "continuum/session.hpp"

#include "continuum/expect.hpp"

#include <deal.II/base/multithread_info.h>

#include <petscsys.h>

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
  state = State::active;
}

Session::~Session() {
  state = State::over;
  PetscFinalize();
}

bool Session::is_active() {
  return state == State::active;
}

} // namespace continuum
