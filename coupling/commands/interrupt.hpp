#pragma once

namespace coupling {

/// While it lives, the first SIGINT or SIGTERM is only noted; a second one ends the program as
/// usual.
class InterruptWatch {
public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(InterruptWatch const&) = delete;
  InterruptWatch& operator=(InterruptWatch const&) = delete;

  static bool is_requested();

  /// The signal that asked; 0 while none has.
  static int signal();
};

} // namespace coupling
