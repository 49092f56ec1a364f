#pragma once

#include "coupling/load_cell.hpp"
#include "coupling/press_frame.hpp"
#include "coupling/reduced/bed_law.hpp"

#include <vector>

namespace coupling::reduced {

/// What the machine is told: gaps at times, straight lines between them. Times increase.
struct GapCourse {
  std::vector<double> time; ///< [s]
  std::vector<double> gap;  ///< [m], > 0

  /// Held before the first and after the last point.
  double at(double t) const;
};

/// Down to `end_gap` and up again at constant speeds, with a dwell between.
/// @param speed_down, speed_up  [m/s], > 0
GapCourse press_course(double fill_height, double end_gap, double speed_down, double speed_up,
                       double dwell = 0.0);

/// One moment of a cycle.
struct ChainReading {
  double time;          ///< [s]
  double commanded_gap; ///< [m], what the machine takes the gap to be
  double height;        ///< [m], what it is
  BedForces forces;
  double load_cell; ///< [N], what the cell on the upper punch shows
};

/// The whole way from a command to what a laboratory writes down: machine, bed, load cell. At each
/// moment the height is where bed and frame agree,
///   h = h_cmd(t) + z_0 + e t + D(F_upper(h)),
/// to rounding. Machine and load cell are those of the grains' simulator.
/// @param samples  [s], increasing; corners of the course need not be among them
/// @throws dem::InvalidInput for numbers that make no bed, no course, or a gap of nothing
std::vector<ChainReading> press_cycle(BedLaw const& law, Bed const& bed, FrameLaw const& frame,
                                      LoadCellErrors const& load_cell, GapCourse const& course,
                                      std::vector<double> const& samples);

} // namespace coupling::reduced
