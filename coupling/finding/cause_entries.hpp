#pragma once

#include "coupling/case.hpp"
#include "coupling/finding/finding_parts.hpp"

/// Which entries of a case model a cause: the table between the diagnosis' names and the
/// simulator's blocks.
namespace coupling::finding {

/// What a run says of its contacts and cannot be read off the case. NaN where it is not known.
struct BedFacts {
  /// Mean overlap over effective radius R* of the contacts at the largest force [1].
  double relative_overlap = not_known;
  /// F / (dF/dt) at the largest force, in the case's own time [s].
  double growth_time = not_known;
};

/// One entry with its new value as a person would write it.
struct EntryChange {
  std::string path, text;
};

/// Entries that model a cause, or why there are none.
struct CauseEntries {
  std::vector<EntryChange> changes = {};
  std::string obstacle = {}; ///< a sentence; empty where there are changes
};

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
///   plastic_contacts   share a of Hertz' force that yielding takes at the overlap d of full load:
///                      a = 1 - 3/2 s + s^3/2,  s^2 = d_y / d,  p_y = 2 E* / pi sqrt(d_y / R*)
///                                                     Contact/Normal law, Yield pressure
///   rate_dependence    A = a F / (dF/dt), so that d ln F / d ln v = a   Contact/Viscous time
///   die_compliance     1/E' = 1/E + a / (D c),  c = (r_o^2 + r_i^2) / (r_o^2 - r_i^2) + nu
///                                                     Deformable tools/Young's modulus, Mode
///   punch_tilt         tilt + a                       Tooling/Punch tilt
///   multi_contact      b + 0.3 a (README)             Contact/Multi-contact coefficient
/// A parameter of the cause that is named as an entry is (stiffness, seating, seating_force,
/// yield_pressure, viscous_time) is taken as it stands.
/// Sources: Thornton and Ning, Powder Technol. 99 (1998) 154, eqs 13 to 22, for p_y; Timoshenko and
/// Goodier, Theory of Elasticity (1970), section 28, for the thick ring.
CauseEntries case_entries_of(FoundCause const& cause, Case const& setup, BedFacts const& facts);

/// The same for a calibrated parameter: young_modulus and cohesion (or cohesion_energy_density)
/// scaled so that the first component, or the grains' pairs, have the value.
CauseEntries case_entries_of(CalibratedValue const& value, Case const& setup);

} // namespace coupling::finding
