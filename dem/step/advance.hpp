#pragma once

#include "dem/step/world.hpp"

namespace dem {

/// Computes the forces of the present state without moving anything or advancing contact history:
/// call once after a World has been built or its tools were changed by hand.
void prepare(World& world);

/// One step of velocity Verlet, kick-drift-kick:
///   v += dt/2 F/m, w += dt/2 T/I, x += dt v;  tools move;  F, T from the new x with the half-step
///   v, w;  second half kick.
/// Tools move with their `velocity`; their force, radial force and work are those of this step when
/// it returns. Source: Allen and Tildesley, Computer Simulation of Liquids (2017), 3.2; order of
/// operations as in LIGGGHTS' (contact-law notes, section 3).
/// @throws PhysicsGuard if a grain's position is no longer finite
void advance(World& world, double dt);

/// The same but for the second half kick of the grains, which the next step gives together with its
/// first one: one pass through memory less a step, and the same bits. Until complete_step() the
/// grains' velocities, spins, forces and torques are those of the half step; positions, tools and
/// energies are those of the step.
void advance_ahead(World& world, double dt);

/// Ends a step that advance_ahead() began; otherwise nothing.
void complete_step(World& world);

/// Smallest Rayleigh time of the grains [s]:  pi R sqrt(rho/G) / (0.1631 nu + 0.8766),  G = E / (2
/// (1 + nu)). Source: Li, Xu and Thornton, Powder Technol. 160 (2005) 219 (the seed's definition).
double rayleigh_time(World const& world);

/// Largest stable step [s] of the present contacts, springs and dashpots (see
/// dem/contact/stable_step.hpp).
double stable_time_step(World const& world);

} // namespace dem
