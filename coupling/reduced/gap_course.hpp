#pragma once

#include <vector>

namespace coupling::reduced {

/// What the machine is told: gaps at times, straight lines between them. Times increase.
struct GapCourse {
  std::vector<double> time; ///< [s]
  std::vector<double> gap;  ///< [m], > 0

  /// Held before the first and after the last point.
  double at(double t) const;
};

/// Refuses what is no course. @throws dem::InvalidInput
void validate(GapCourse const& course);

/// Down to `end_gap` and up again at constant speeds, with a dwell between.
/// @param speed_down, speed_up  [m/s], > 0
GapCourse press_course(double fill_height, double end_gap, double speed_down, double speed_up,
                       double dwell = 0.0);

/// When a course turns: the first and the last of its lowest points.
struct Turning {
  double closed; ///< [s], when the closing ends
  double opens;  ///< [s], when the opening begins
  double gap;    ///< [m], between
};
Turning turning_of(GapCourse const& course);

} // namespace coupling::reduced
