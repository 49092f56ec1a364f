#pragma once

#include "coupling/press_measures.hpp"

namespace coupling {

/// Stops a run whose result could not be trusted: a value that is not finite, an overlap beyond the
/// limit, grains that went through a wall, energy that nobody put in (an unstable step heats
/// instead of exploding).
/// @throws dem::PhysicsGuard  naming the guard, the place in the run, the evidence and a way out
void guard(Press const& press, Reading const& reading);

/// Whether a tool's force is still a number: cheap enough for every step.
void guard_step(dem::World const& world);

/// What errors are measured by: the largest work so far, or what was there at the start, or what
/// gravity could do [J]; likewise for the momentum along the axis [N s].
double energy_scale(Press const& press);
double impulse_scale(Press const& press);

/// Largest share of the grains' Hertz collision time that the present step may be; more is a failed
/// check.
inline constexpr double largest_step_to_collision = 0.1;

/// Ratio of the present step to the Hertz collision time of two equal grains that meet at the
/// largest speed at hand.
///   t_c = 2.87 (m^2 / (R/2 E*^2 v))^(1/5),  v = max(2 v_max, v_max + v_tool)
/// Source: Johnson, Contact Mechanics (1985), 11.4; v as LIGGGHTS takes it.
double step_to_collision_time(Press const& press, double step);

} // namespace coupling
