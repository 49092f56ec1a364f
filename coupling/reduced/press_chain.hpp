#pragma once

#include "coupling/load_cell.hpp"
#include "coupling/press_frame.hpp"
#include "coupling/reduced/gap_course.hpp"
#include "coupling/reduced/pressed_bed.hpp"

#include <vector>

namespace coupling::reduced {

/// The machine between command and paper.
struct Machine {
  FrameLaw frame = {};
  /// [1/m], how much the gap's offset z grows as the gap does: z (1 + pitch (h_cmd - h_turn)).
  double gap_pitch = 0.0;
  /// [1/s], how fast the thermal drift e dies out: its travel is e (1 - exp(-w t)) / w; 0: e t.
  double drift_decay = 0.0;
  LoadCellErrors load_cell = {};
  /// [1], share of the cell's lag that a second stage behind it has.
  double second_stage = 0.0;
  bool gap_is_of_faces = false; ///< what is called the gap is measured at the punch faces
};

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
///   h = h_cmd(t) + z (1 + pitch (h_cmd - h_turn)) + e (1 - exp(-w t)) / w + D(F_upper(h)),
/// to rounding; without D where the gap is measured at the faces. Frame and load cell are those of
/// the grains' simulator.
/// @param samples  [s], increasing; corners of the course need not be among them
/// @throws dem::InvalidInput for numbers that make no bed, no course, or a gap of nothing
std::vector<ChainReading> press_cycle(PressedBed const& pressed, Machine const& machine,
                                      GapCourse const& course, std::vector<double> const& samples);

/// The smallest height of a cycle [m].
double smallest_height(std::vector<ChainReading> const& readings);

} // namespace coupling::reduced
