#pragma once

#include <cstdio>
#include <string>

namespace continuum {

/// A value as messages show it.
inline std::string quote(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

} // namespace continuum
