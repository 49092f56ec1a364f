#include "coupling/commands/interrupt.hpp"

#include <csignal>

namespace coupling {
namespace {

volatile std::sig_atomic_t requested = 0;

void note_request(int signal) {
  requested = signal;
}

void set_handler(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  // One polite request; whoever asks twice means it.
  action.sa_flags = handler == note_request ? static_cast<int>(SA_RESETHAND | SA_RESTART) : 0;
  sigaction(signal, &action, nullptr);
}

} // namespace

InterruptWatch::InterruptWatch() {
  requested = 0;
  set_handler(SIGINT, note_request);
  set_handler(SIGTERM, note_request);
}

InterruptWatch::~InterruptWatch() {
  set_handler(SIGINT, SIG_DFL);
  set_handler(SIGTERM, SIG_DFL);
}

bool InterruptWatch::is_requested() {
  return requested != 0;
}

int InterruptWatch::signal() {
  return requested;
}

} // namespace coupling
