#pragma once

#include "coupling/case.hpp"
#include "coupling/finding/entry_change.hpp"

/// Which entries of a case model a cause: the table between the diagnosis' names and the
/// simulator's blocks.
namespace coupling::finding {

/// The entries of one cause on top of what the case has:
///   frame_compliance   1/K' = 1/K + a                 Press frame/Stiffness (K = 0: rigid)
///   gap_offset         z + a                          Press frame/Gap offset
///   thermal_drift      e + a                          Press frame/Thermal drift
///   force_gain         g (1 + a)                      Load cell/Gain
///   force_offset       o + a                          Load cell/Offset
///   force_lag          tau + a                        Load cell/Time constant
///   mass_error         m (1 + a)                      Powder/Total mass
///   die_size           D + a                          Tooling/Bore diameter
///   wall_friction      mu + a                         Contact/Particle-wall/...static friction
///   particle_friction  mu + a                         Contact/Particle-particle/...
///   young_modulus      E (1 + a), every component     Powder/Component N/Young's modulus
///   cohesion           k (1 + a), both                Contact/.../Cohesion energy density
///   rate_dependence    A = a F / (dF/dt), so that d ln F / d ln v = a   Contact/Viscous time
///   die_compliance     1/E' = 1/E + a / (D c),  c = (r_o^2 + r_i^2) / (r_o^2 - r_i^2) + nu
///                                                     Deformable tools/Young's modulus, Mode
///   punch_tilt         tilt + a                       Tooling/Punch tilt
/// and those of a dose, dosed_entries.hpp.
/// A parameter of the cause that is named as an entry is (stiffness, seating, seating_force,
/// viscous_time) is taken as it stands.
/// Source of the thick ring: Timoshenko and Goodier, Theory of Elasticity (1970), section 28.
CauseEntries case_entries_of(FoundCause const& cause, Case const& setup, BedFacts const& facts);

/// The same for a calibrated parameter: young_modulus and cohesion (or cohesion_energy_density)
/// scaled so that the first component, or the grains' pairs, have the value.
CauseEntries case_entries_of(CalibratedValue const& value, Case const& setup);

} // namespace coupling::finding
