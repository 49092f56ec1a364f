#include "coupling/elastic/session.hpp"

#include "continuum/session.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

namespace coupling {

void ensure_session() {
  if (!continuum::Session::is_active())
    static continuum::Session const session;
}

bool help_first_rank() {
  int const n_started = continuum::n_started_processes();
  if (n_started == 0)
    return false;
  ensure_session();
  VALIDATE(n_ranks() >= n_started,
           fmt::format("mpirun: {} processes were started, and MPI knows of {} (they would write "
                       "into one folder). Does mpirun belong to another MPI than Open MPI?",
                       n_started, n_ranks()));
  if (!continuum::Session::is_helper())
    return false;
  continuum::Session::help();
  return true;
}

int n_ranks() {
  return continuum::Session::n_ranks();
}

} // namespace coupling
