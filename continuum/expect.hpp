#pragma once

#include "continuum/errors.hpp"

/// VALIDATE(condition, message): always on; for what a person wrote or a file holds. Only sources
/// include this header: dem/ has a macro of the same name for its own errors.
#define VALIDATE(condition, message)                                                               \
  do {                                                                                             \
    if (!(condition))                                                                              \
      throw ::continuum::InvalidInput(message);                                                    \
  } while (false)
