#include "continuum/ranks.hpp"

#include "continuum/errors.hpp"

#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstring>
#include <thread>

namespace continuum::ranks {

namespace {
constexpr unsigned patience = 60; // s
constexpr std::size_t longest_text = 1024;

// Requests and agreements keep out of the way of PETSc's messages.
MPI_Comm ours = MPI_COMM_NULL;
int n_ranks = 1;
int own_rank = 0;

std::array<char, longest_text> last_words;

void check(int code) {
  if (code != MPI_SUCCESS)
    throw SolverFailure("MPI: a message between ranks failed. Are all machines still there?");
}

// MPI's own waits spin. Between requests the cores belong to the grains of the first rank, so a
// wait sleeps: 10 ms are nothing against a factorisation, and 100 tests a second cost no core.
void wait_asleep(MPI_Request& pending) {
  using namespace std::chrono_literals;
  auto pause = 50us;
  for (int is_done = 0;;) {
    check(MPI_Test(&pending, &is_done, MPI_STATUS_IGNORE));
    if (is_done)
      return;
    std::this_thread::sleep_for(pause);
    pause = std::min<std::chrono::microseconds>(2 * pause, 10ms);
  }
}

void broadcast_bytes(void* data, std::size_t n_bytes, int from) {
  MPI_Request pending;
  check(MPI_Ibcast(data, static_cast<int>(n_bytes), MPI_BYTE, from, ours, &pending));
  wait_asleep(pending);
}

// Only what a signal handler may call. mpirun ends the ranks that are left.
void give_up(int) {
  auto const unused = write(STDERR_FILENO, last_words.data(), std::strlen(last_words.data()));
  static_cast<void>(unused);
  _exit(1);
}

std::array<char, longest_text> as_block(std::string const& text) {
  std::array<char, longest_text> block{};
  std::copy_n(text.begin(), std::min(text.size(), block.size() - 2), block.begin());
  return block;
}
} // namespace

void open() {
  check(MPI_Comm_dup(MPI_COMM_WORLD, &ours));
  check(MPI_Comm_size(ours, &n_ranks));
  check(MPI_Comm_rank(ours, &own_rank));
}

void close() {
  if (is_first())
    announce({.task = Task::stop});
  MPI_Comm_free(&ours);
  n_ranks = 1;
}

int count() {
  return n_ranks;
}

int own() {
  return own_rank;
}

bool is_first() {
  return own_rank == 0;
}

void announce(Request const& request) {
  if (n_ranks == 1)
    return;
  Request message = request;
  broadcast_bytes(&message, sizeof message, 0);
}

Request next() {
  Request request{};
  broadcast_bytes(&request, sizeof request, 0);
  return request;
}

void broadcast(double* values, std::ptrdiff_t n) {
  check(MPI_Bcast(values, static_cast<int>(n), MPI_DOUBLE, 0, ours));
}

void send(double const* values, std::ptrdiff_t n) {
  check(MPI_Send(values, static_cast<int>(n), MPI_DOUBLE, 0, 0, ours));
}

void receive(double* values, std::ptrdiff_t n, int from) {
  check(MPI_Recv(values, static_cast<int>(n), MPI_DOUBLE, from, 0, ours, MPI_STATUS_IGNORE));
}

void agree(std::string const& failure) {
  int const own = failure.empty() ? INT_MAX : own_rank;
  int failed = INT_MAX;
  MPI_Request pending;
  check(MPI_Iallreduce(&own, &failed, 1, MPI_INT, MPI_MIN, ours, &pending));
  wait_asleep(pending);
  if (failed == INT_MAX)
    return;
  auto text = as_block(is_first() ? failure : "rank " + std::to_string(own_rank) + ": " + failure);
  broadcast_bytes(text.data(), text.size(), failed);
  alarm(0);
  throw SolverFailure(text.data());
}

void expect_agreement(std::string const& failure) {
  if (n_ranks == 1)
    return;
  last_words = as_block(failure);
  last_words[std::strlen(last_words.data())] = '\n';
  std::signal(SIGALRM, give_up);
  alarm(patience);
}

} // namespace continuum::ranks
