#pragma once

/// Every limit that the reading of measured data rests on, with its reason.
namespace coupling::measured::limits {

/// Rows of a file that may be corrupt and left out. Beyond one in twenty the fault is the file's,
/// not a row's, and faults that nobody can see must be expected among the rest.
constexpr double corrupt_share = 0.05;

/// Mean pressures of powder pressing [Pa], from a tapped bed to tungsten carbide tooling. Force in
/// the wrong unit by 1000 leaves this range if the true pressure is between 2 and 500 MPa.
constexpr double least_pressure = 0.5e6, largest_pressure = 2e9;

/// Mass over volume at the end gap [kg/m^3]: above the lightest pressed powders (aerogel), below
/// the densest metal (osmium, 22600).
constexpr double least_density = 50.0, largest_density = 25e3;

/// A factor is nearer to 1000 (or 1/1000) than to 1 beyond sqrt(1000).
constexpr double unit_factor = 31.6;

/// End gap: part of the stroke (fill height less end gap) by which reading and protocol may differ.
/// A drive stops closer, but zeros of travel are set by hand; runs that are meant to differ do so
/// by more.
constexpr double end_gap_share = 0.05;

/// Speed: 10 % changes an effect that goes with the logarithm of the rate by 4 % of what a decade
/// does; more is another protocol.
constexpr double speed_share = 0.1;

/// Softest press with its tools that is credible [N/m]: half of the softest that the seed's numbers
/// allow (20 kN/mm). What it yields may stand between a measured and a commanded gap.
constexpr double frame_stiffness = 10e6;

/// Standard uncertainties that noise does not exceed in a record of ten thousand readings (1e-6
/// two-sided at 4.9).
constexpr double noise_sds = 5.0;

/// Part of the stroke above the smallest gap in which the force has its maximum, and the part of
/// the gap that may pass for the protocol's where columns are suspected to be swapped.
constexpr double turning_share = 0.1;

/// A reading that leaves the line between its neighbours by this many steps of its surroundings,
/// this many standard uncertainties and this part of the channel's range came from the line, not
/// from the press: no press goes there and back between two samples.
constexpr double spike_steps = 5.0, spike_sds = 20.0, spike_share = 0.1;

} // namespace coupling::measured::limits
