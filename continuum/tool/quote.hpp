#pragma once

#include <Eigen/Core>

#include <cstdio>
#include <string>

namespace continuum {

/// A value as messages show it.
inline std::string quote(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// A position [m].
inline std::string quote_position(Eigen::Vector3d const& x) {
  return std::string("(") + quote(x.x()) + ", " + quote(x.y()) + ", " + quote(x.z()) + ") m";
}

} // namespace continuum
