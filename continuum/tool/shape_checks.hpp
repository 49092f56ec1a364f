#pragma once

#include "continuum/expect.hpp"
#include "continuum/tool/quote.hpp"

#include <algorithm>
#include <cmath>

// What generators of meshes refuse. For sources only.
namespace continuum {

inline void validate_length(char const* what, double value) {
  VALIDATE(std::isfinite(value) && value > 0.0,
           std::string(what) + " = " + quote(value) + " m (a length is positive). Is it misspelt?");
}

inline void validate_larger(char const* what, double value, char const* than, double smaller) {
  VALIDATE(std::isfinite(value) && value > smaller,
           std::string(what) + " = " + quote(value) + " m is not beyond the " + than + " = " +
               quote(smaller) + " m (no wall is left between). Are the two exchanged?");
}

inline void validate_count(char const* what, int value, int multiple) {
  VALIDATE(value > 0 && value <= 4096 && value % multiple == 0,
           std::string("cells ") + what + " = " + std::to_string(value) + " (a multiple of " +
               std::to_string(multiple) + ", up to 4096). Take " +
               std::to_string(std::clamp((value + multiple - 1) / multiple, 1, 4096 / multiple) *
                              multiple) +
               "?");
}

inline void validate_growth(double growth) {
  VALIDATE(growth >= 0.01 && growth <= 100.0,
           "growth of cells = " + quote(growth) +
               " (between 0.01 and 100, or cells degenerate). 1 makes them equal?");
}

} // namespace continuum
