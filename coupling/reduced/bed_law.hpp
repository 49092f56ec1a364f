#pragma once

#include "coupling/reduced/table.hpp"

namespace coupling::reduced {

/// A fill that is not settled: the onset lies lower by size (1 + tail s0 / decay)^(-1 / tail); tail
/// 0: size exp(-s0 / decay), 1: size / (1 + s0 / decay).
struct OnsetFill {
  double size = 0.0;  ///< [1]
  double decay = 2e6; ///< [Pa], > 0
  double tail = 0.0;  ///< [1], >= 0
};

/// Fines that are missing between the grains: the onset lies lower by size (1 - fade s0 / (s0 +
/// scale)), since pressing closes a part of the gaps.
struct OnsetFines {
  double size = 0.0;   ///< [1]
  double fade = 0.0;   ///< [1], <= 1
  double scale = 40e6; ///< [Pa], > 0
};

/// Grains that break and fill gaps: the onset lies higher by size (1 - exp(-(s0 / scale)^modulus)).
struct OnsetCrush {
  double size = 0.0;    ///< [1]
  double scale = 25e6;  ///< [Pa], > 0
  double modulus = 2.0; ///< Weibull's [1], > 0
};

/// Contacts that stiffen each other: K (1 + size x^exponent).
struct Stiffening {
  double size = 0.0;     ///< [1]
  double exponent = 3.0; ///< [1], > 0
};

/// Contacts that yield: of s, size e^2 / (e + stress) is lost, e = max(0, s - stress).
struct Yielding {
  double size = 0.0;    ///< [1], share that is lost far beyond
  double stress = 20e6; ///< [Pa], > 0
};

/// Of r: a bed does not open beyond the height at which it began to bear by more than this.
inline constexpr double largest_recovery = 1.5;

/// A powder bed between punches as one column: what thousands of grains sum up to, in a few numbers
/// and the curves that a simulation filled in (fit_bed_law). phi is the solid fraction over the
/// whole height, x = phi - phi_c what it lies above the onset, s the mean of both punches' stress.
///   first loading  s = K (1 + a x^m) x^n - S x + K loading_rest(x), less what yielding loses
///   unloading      s = s_m unloading(g)^p,  g = 1 - ln(phi_m / phi) / (r ln(phi_m / phi_c))
/// from the largest solid fraction phi_m on; reloading goes back the same way. (In logarithmic
/// strain curves from different phi_m fall on each other; README.) Radial pressure
///   first loading  p = k radial_loading(x) s
///   unloading      p = p_m radial_unloading(g)
/// The wall carries W = t mu wall_loading(x) p pi D h, t = 1 while the bed closes, then
/// wall_turn((h - h_m) (p_t / p_m)^0.25 mu_t / mu), x that of phi_m; it never carries more than the
/// bed bears, |W| <= 2 A s:
///   F_upper = A s + W / 2,  F_lower = A s - W / 2.
/// The onset shifts with how far loading has gone, phi_c - fill - fines + crush, all of the stress
/// s0 that the bed bears there in first loading. An empty table stands for what is written beside
/// it.
struct BedLaw {
  double stiffness = 0.0;     ///< K [Pa], grows with Young's modulus
  double cohesion = 0.0;      ///< S [Pa], grows with the cohesion energy density
  double onset = 0.0;         ///< phi_c [1], where the bed begins to bear
  double exponent = 1.5;      ///< n [1]; 3/2 for Hertz contacts that keep their number
  double recovery = 0.9;      ///< r [1], share of the way to the onset that unloading goes back
  double wall_friction = 0.0; ///< mu [1], of the powder on the die
  double radial_ratio = 0.5;  ///< k [1]
  double opening = 2.5;       ///< p [1], exponent of unloading; 1 with a fitted table
  double reversal = 1e-4;     ///< d [m], while `wall_turn` is empty

  /// g at which the upper punch leaves the compact [1], of the cycle that filled the tables; 0:
  /// where its force has fallen to free_share.
  double free_way = 0.0;
  /// p_t [Pa] and mu_t [1] of the turn that `reversal` and `wall_turn` are of; 0: of any. Measured
  /// on beds of grains (README).
  double turn_pressure = 0.0, turn_friction = 0.0;

  OnsetFill onset_fill = {};
  OnsetFines onset_fines = {};
  OnsetCrush onset_crush = {};
  Stiffening stiffening = {};
  Yielding yielding = {};

  Table loading_rest = {};     ///< what the formula misses, / K, over x, also below 0 [1]; empty: 0
  Table unloading = {};        ///< (s / s_m)^(1/p) over g [1], from 0 to 1 at g = 1; empty: g
  Table radial_loading = {};   ///< factor on k over x [1]; empty: 1
  Table radial_unloading = {}; ///< p / p_m over g [1], to 1 at g = 1; empty: sqrt(s / s_m)
  Table wall_loading = {};     ///< factor on mu over x [1]; empty: 1
  Table wall_turn = {}; ///< t over h - h_m [m], from 1 at 0; empty: -1 + 2 exp(-(h - h_m) / d)

  /// Not below 0. @param solid_fraction  phi
  double loading(double solid_fraction) const;
  /// @param most  phi_m >= phi
  double unloading_stress(double solid_fraction, double most) const;
  /// phi_c as it is when first loading has come to phi.
  double onset_at(double solid_fraction) const;
};

/// The wall's friction turns round over `factor` times the length.
void stretch_turn(BedLaw& law, double factor);

/// Refuses numbers that make no bed. @throws dem::InvalidInput
void validate(BedLaw const& law);

/// A bed of given mass in its die.
struct Bed {
  double solid_area; ///< V_solid / A [m]: the height at solid fraction 1
  double bore;       ///< D [m]
};

/// What the punches and the die feel.
struct BedForces {
  double upper = 0.0, lower = 0.0; ///< [N]
  double radial_pressure = 0.0;    ///< [Pa]
};

/// What a bed has come to.
struct BedState {
  double height;               ///< h [m]
  double opened;               ///< h - h_m [m]
  double solid_fraction, most; ///< phi, phi_m >= phi
};
BedForces bed_forces(BedLaw const& law, Bed const& bed, BedState const& state);

/// Forces at the height h when the smallest height so far is h_m <= h.
BedForces bed_forces(BedLaw const& law, Bed const& bed, double height, double smallest_height);

/// The compact in its die when the upper punch leaves it: at the law's free_way, or where its force
/// has fallen to free_share of what it was at h_m. (How the last of it fades is no measurement, and
/// what hangs on the wall is no elasticity: in a fitted law neither friction nor depth moves the g
/// of that moment. What the wall still holds may press on the lower punch.)
inline constexpr double free_share = 5e-4;
struct FreeCompact {
  double height;          ///< [m]
  double radial_pressure; ///< that remains there [Pa]
};
FreeCompact free_compact(BedLaw const& law, Bed const& bed, double smallest_height);

/// The g at which a height is reached from a turn at smallest_height [1].
double way_left_at(BedLaw const& law, Bed const& bed, double height, double smallest_height);

} // namespace coupling::reduced
