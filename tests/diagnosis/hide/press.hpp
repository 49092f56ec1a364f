#pragma once

#include "tests/diagnosis/hide/column.hpp"

#include <cstdint>
#include <vector>

namespace hidden {

/// What the press is told.
struct Protocol {
  double speed_down = 1.0 * mm / 60.0; ///< [m/s]
  double speed_up = 25.0 * mm / 60.0;  ///< [m/s]
  double end_gap = 8.0 * mm;           ///< [m]
  double dwell = 0.0;                  ///< [s]
  double fill_height = 20.0 * mm;      ///< [m]

  double closing_time() const { return (fill_height - end_gap) / speed_down; }
  double end_time() const { return closing_time() + dwell + (fill_height - end_gap) / speed_up; }
  double gap_at(double time) const; ///< as commanded [m]
};

/// What differs between pressings that are meant to be the same.
struct Repeat {
  double mass = 0.0;       ///< relative
  double packing = 0.0;    ///< on the onset [1]
  double friction = 0.0;   ///< of the wall, relative
  double zero = 0.0;       ///< of the gap [m]
  double cell_zero = 0.0;  ///< of the load cell [N]
  double mass_error = 0.0; ///< how far this run's mass error is from the mean one, relative
};

/// The sheet: what the laboratory believes.
constexpr double stated_mass = 9.13e-3;  ///< [kg]
constexpr double stated_bore = 22.05e-3; ///< [m]

/// One moment, before the noise of the sensors.
struct Moment {
  double time, gap;    ///< [s], [m] commanded
  double height;       ///< between the faces [m]
  double upper, lower; ///< as the gauges show them [N]
  double radial;       ///< [Pa], mean of the gauges at the top and at the bottom
};

struct Cycle {
  std::vector<Moment> moments;
  double compact_height = 0.0; ///< [m]
  double ejection_force = 0.0; ///< [N]
};

/// One pressing: machine, bed, gauges. The height is where they agree,
///   h = h_commanded + zero + drift + frame(F_upper(h)).
Cycle press_cycle(Powder const& powder, Effects const& effects, Protocol const& protocol,
                  Repeat const& repeat = {});

} // namespace hidden
