#pragma once

#include "tests/diagnosis/hide/cases.hpp"

#include <vector>

namespace hidden {

/// Standard uncertainties of the sensors: of a reading sqrt(sd^2 + (relative y)^2).
struct Sensor {
  double sd, relative;
  double at(double reading) const;
};
constexpr Sensor gap_sensor{2e-6, 0.0}, force_sensor{12.0, 0.0005}, pressure_sensor{8e4, 0.001};
constexpr double height_sd = 15e-6, ejection_sd = 10.0; ///< [m], [N]

/// Rows of one run's file.
struct Readings {
  std::vector<double> time, gap, upper, lower, radial;
  double compact_height, ejection_force;
};

/// Reads a cycle with the run's own clock: about 2 to 4 rows a second at 1 mm/min, 10 to 20 at 25,
/// unevenly, with white noise.
Readings read_cycle(Cycle const& cycle, Protocol const& protocol, std::uint64_t seed,
                    std::uint64_t run);

} // namespace hidden
