#include "coupling/commands/commands.hpp"

#include <iostream>

namespace coupling::commands {

int defaults(DefaultsFormat format) {
  std::cout << describe_entries(format);
  return done;
}

} // namespace coupling::commands
