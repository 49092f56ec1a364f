#pragma once

#include "coupling/press.hpp"

namespace coupling {

/// How much a run calculates.
struct RunSize {
  double grains;
  double step;      ///< [s], longest allowed as the bed lies now
  double simulated; ///< [s], expected
  double steps; ///< expected; fewer than the run's where the step adapts or a force ends a stage

  double particle_steps() const { return grains * steps; }
};

RunSize run_size(Press const& press);

/// What a step of a bed costs, as loose as it lies.
struct StepCost {
  double bytes;   ///< of grains, lists and records
  double seconds; ///< of wall clock
};

/// Runs a few steps of a copy: the press itself stays as it is. @param step  [s]
StepCost measure_step(dem::World world, double step);

/// What the engine is allowed, its contacts included.
inline constexpr double bytes_a_pressed_grain = 1000.0;

/// A step of the pressed bed costs about so many times a step of the filling, measured over the
/// seed's cycle.
inline constexpr double pressed_to_loose = 5.0;

} // namespace coupling
