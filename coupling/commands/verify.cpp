#include "coupling/verification/verify.hpp"
#include "coupling/commands/commands.hpp"

namespace coupling::commands {

int verify(std::string const& filter) {
  return verification::run_verification({.filter = filter, .folder = "."});
}

} // namespace coupling::commands
