#pragma once

#include "tests/regression/program.hpp"

#include <string>

/// Commands over ranks, as a user would start them. Cores may be fewer than ranks, and the tests
/// may run as root in a container.
namespace mpirun {

inline std::string const starter =
    "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 exec mpirun --quiet --oversubscribe "
    "--bind-to none";

/// The command on n ranks; `settings` go before mpirun: "PRESSCHECK_CACHE=folder".
inline program::Outcome run(int n, std::string const& command, std::string const& settings = "") {
  return program::run(
      {"sh", "-c", settings + " " + starter + " -n " + std::to_string(n) + " " + command});
}

/// The command without mpirun.
inline program::Outcome run_alone(std::string const& command, std::string const& settings = "") {
  return program::run({"sh", "-c", settings + " " + command});
}

} // namespace mpirun
