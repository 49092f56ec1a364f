#pragma once

#include <cstddef>
#include <exception>
#include <string>
#include <utility>

/// The processes that `mpirun -n N` starts. The first is the program: it alone reads, writes and
/// moves grains. The others help it with the tools: they wait for a request, take part in it as
/// the first does, and wait again. One process alone is the first of one, and nothing here does
/// anything.
namespace continuum::ranks {

enum class Task : int { stop, factorise, solve, condense, invert, forget };

/// What the first rank asks of all.
struct Request {
  Task task;
  int factor = 0; ///< number of a factorisation
  int size = 0;   ///< rows of the matrix
};

/// @throws SolverFailure if MPI fails; by Session, once MPI has started
void open();
/// Ends the helpers' wait, if this is the first rank. By Session, before MPI ends.
void close();

int count();     ///< 1 before MPI has started
int own();       ///< this rank, from 0; 0 before MPI has started
bool is_first(); ///< true before MPI has started

/// First rank: all ranks begin a task.
void announce(Request const& request);
/// Helpers: waits for the next task, asleep: see `ranks.cpp`.
Request next();

/// Inside a task: n numbers of the first rank to all, or of another to the first.
/// @throws SolverFailure
void broadcast(double* values, std::ptrdiff_t n);
void send(double const* values, std::ptrdiff_t n);
void receive(double* values, std::ptrdiff_t n, int from);

/// Closes a task: where a rank failed, every rank throws the failure of the lowest such rank.
/// @param failure  of this rank; empty if all is well
/// @throws SolverFailure
void agree(std::string const& failure);

/// At an error inside a task, before the stack unwinds: if the other ranks do not come to `agree`
/// within a minute, they wait for this one in a call that it has left, and the program ends
/// (status 1, `failure` on standard error).
void expect_agreement(std::string const& failure);

/// Runs this rank's part of a task to its agreement.
/// @throws SolverFailure where the part failed on any rank; alone, what the part throws
template <class Part> void together(Part part) {
  if (count() == 1)
    return part();
  std::string failure;
  try {
    part();
  } catch (std::exception const& error) {
    failure = error.what();
    expect_agreement(failure);
  }
  agree(failure);
}

} // namespace continuum::ranks
