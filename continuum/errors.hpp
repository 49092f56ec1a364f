#pragma once

#include <stdexcept>
#include <string>

/// What continuum/ throws. The message grammar: `where: what is wrong (why it is). A way out?`
namespace continuum {

/// What a person wrote, or a file holds, cannot be used.
struct InvalidInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A check of the solution failed: the linear solver gave up or left too large a residual.
struct SolverFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

} // namespace continuum
