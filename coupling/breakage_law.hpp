#pragma once

#include <cstdint>

namespace coupling {

/// When grains break: a grain is crushed where the largest force of a contact on it, over the
/// square of its diameter, reaches its strength. Strengths are drawn from Weibull's law, by which
/// a share exp(-(d/d_0)^3 (sigma/sigma_0)^m) of grains of diameter d survives sigma:
///   sigma_f = sigma_0 (d/d_0)^(-3/m) (-ln u)^(1/m),   u uniform in (0, 1].
/// Source: Weibull, J. Appl. Mech. 18 (1951) 293; sigma = F/d^2: Jaeger, Int. J. Rock Mech. 4
/// (1967) 219; McDowell and Bolton, Geotechnique 48 (1998) 667.
struct BreakageLaw {
  double strength = 0.0;             ///< sigma_0 [Pa]; 0: grains do not break
  double weibull_modulus = 5.0;      ///< m [1]
  double reference_diameter = 1e-3;  ///< d_0 [m]
  double smallest_diameter = 0.5e-3; ///< [m], grains of up to this size do not break

  bool is_on() const { return strength > 0.0; }
};

/// Strength of a grain [Pa]: always the same for the same seed, id and diameter.
/// @param diameter  [m]
double strength_of(BreakageLaw const& law, std::uint64_t seed, std::uint32_t id, double diameter);

} // namespace coupling
