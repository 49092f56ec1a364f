#pragma once

namespace coupling::reduced {

/// A powder bed between punches as one column: what thousands of grains sum up to, with eight
/// numbers. The mean axial stress over the height, of the solid fraction phi,
///   first loading   s = K (phi - phi_c)^n - S (phi - phi_c)
///   unloading       s = s_m ((phi - phi_u) / (phi_m - phi_u))^p,  phi_u = phi_m - r (phi_m -
///   phi_c)
/// from the largest solid fraction phi_m on, where s_m is what loading reached; reloading goes back
/// the same way. The wall carries part of it: with w = exp(q H / D), H the height and D the bore,
///   s_top = s w^x,  s_bottom = s w^-x,  radial = k s
/// where x is 1 while the bed is closed and turns to -1 as it opens, over the length d:
///   x = -1 + 2 exp(-(h - h_m) / d).
struct BedLaw {
  double stiffness = 0.0;     ///< K [Pa], grows with Young's modulus
  double cohesion = 0.0;      ///< S [Pa], grows with the cohesion energy density
  double onset = 0.0;         ///< phi_c [1], where the bed begins to bear
  double exponent = 1.5;      ///< n [1]; 3/2 for Hertz contacts that keep their number
  double recovery = 0.9;      ///< r [1], share of the way to the onset that unloading goes back
  double unloading = 1.5;     ///< p [1]
  double wall_friction = 0.0; ///< q [1], 2 x coefficient of friction x radial ratio
  double radial_ratio = 0.5;  ///< k [1]
  double reversal = 1e-5;     ///< d [m], over which the friction of the wall turns round

  /// @param solid_fraction  phi; below the onset the bed bears nothing
  double loading(double solid_fraction) const;
  /// @param most  phi_m >= phi
  double unloading_stress(double solid_fraction, double most) const;
};

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

/// Forces at the height h when the smallest height so far is h_m <= h.
BedForces bed_forces(BedLaw const& law, Bed const& bed, double height, double smallest_height);

} // namespace coupling::reduced
