#pragma once

#include <string>

namespace continuum {

/// A bed in a die whose wall bears by friction: the slab of Janssen and Walker, with one ratio K_0
/// of radial to axial stress and one coefficient mu over the whole height, stress even over a
/// section. Compression positive, depth z from the moving punch. With k = 4 mu K_0/D:
///     ds/dz = rho g - k s,   s(z) = s_top exp(-k z) + (rho g/k)(1 - exp(-k z)).
/// Holds while the wall slides everywhere in one direction. Without friction k = 0 is no exception.
/// Source: Janssen (1895); Walker (1923), Trans. Faraday Soc. 19, 73.
struct AxialDecay {
  double diameter;           ///< D [m], > 0
  double height;             ///< H [m], > 0
  double wall_friction;      ///< mu [-], >= 0
  double lateral_ratio;      ///< K_0 [-], >= 0
  double bulk_density = 0.0; ///< rho [kg/m^3], >= 0
  double gravity = 9.80665;  ///< g [m/s^2], towards the fixed punch; counts with a bulk density

  /// @throws InvalidInput for dimensions or ratios that cannot be
  void validate(std::string const& name) const;

  double exponent() const; ///< x = k H = 4 mu K_0 H/D [-]

  /// s(z) [Pa] for a punch stress s_top [Pa] at depth z [m].
  double stress_at(double depth, double top_stress) const;
  double bottom_stress(double top_stress) const; ///< s(H) [Pa]
  double transmission() const;                   ///< s_bot/s_top = exp(-x) [-], without weight
  /// Mean over the height [Pa]; s_top (1 - exp(-x))/x without weight.
  double mean_stress(double top_stress) const;
  /// What the wall bears [N], against the punch:  (s_top - s_bot + rho g H) pi D^2/4.
  double wall_force(double top_stress) const;
};

/// Wall friction from an instrumented die, z from the FIXED punch:
///     mu = D/(4 H) s_bot/s_rad(z) (s_top/s_bot)^(z/H) ln(s_top/s_bot).
/// @param radial_stress  s_rad measured at z [Pa];  @param level  z [m], in [0, H]
/// @return mu [-]
/// Source: powder.md 1.1; it is AxialDecay solved for mu.
double wall_friction_of(double diameter, double height, double top_stress, double bottom_stress,
                        double radial_stress, double level);

} // namespace continuum
