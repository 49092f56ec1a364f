#pragma once

#include "continuum/powder/dual.hpp"
#include "continuum/powder/piecewise_linear.hpp"

#include <string>
#include <variant>

namespace continuum {

/// p and q [Pa] as a law computes them; T is double or a Dual.
template <class T> struct StressPair { T p, q; };

/// Linear elasticity whose moduli follow the density, in the TOTAL elastic strain (Abaqus'
/// convention for field variables, not a rate form):
///     p = K(D) eps_v^e,   q = 3 G(D) eps_q^e,   K = E/(3 (1 - 2 nu)),  G = E/(2 (1 + nu)).
/// A change of D at fixed elastic strain changes the stress; the tangent knows.
/// Source: Abaqus, Drucker-Prager cap with field variables; powder.md 1.1.
struct DensityElasticity {
  PiecewiseLinear young_modulus; ///< E [Pa] over D, > 0
  PiecewiseLinear poisson_ratio; ///< nu [-] over D, in (-1, 0.5)

  /// @param volumetric, deviatoric  elastic strain, compaction positive [-]
  /// @param density                 D [-]
  template <class T>
  StressPair<T> operator()(T const& volumetric, T const& deviatoric, T const& density) const {
    T const E = young_modulus(density);
    T const nu = poisson_ratio(density);
    return {E / (3.0 * (1.0 - 2.0 * nu)) * volumetric, 3.0 * E / (2.0 * (1.0 + nu)) * deviatoric};
  }
  void validate(std::string const& name) const;
};

/// Elasticity of Cam-Clay: the bulk modulus follows the pressure,
///     K = (p + c)/kappa:   p + c = (p_0 + c) exp(eps_v^e/kappa),   q = 3 G eps_q^e,
/// kappa on volumetric (not void-ratio) strain, G constant: it derives from an energy. Elastic
/// strain counts from the isotropic stress p_0, so a point without strain bears p_0.
/// Source: powder.md 1.4 (GEOS, ModifiedCamClay), there with c = 0.
struct PressureElasticity {
  double reference_pressure; ///< p_0 [Pa]
  double kappa;              ///< recompression index [-], > 0
  double shear_modulus;      ///< G [Pa], > 0
  double cohesion = 0.0;     ///< c [Pa], >= 0; p_0 + c > 0

  template <class T>
  StressPair<T> operator()(T const& volumetric, T const& deviatoric, T const&) const {
    using std::exp;
    return {(reference_pressure + cohesion) * exp(volumetric / T(kappa)) - cohesion,
            3.0 * shear_modulus * deviatoric};
  }
  void validate(std::string const& name) const;
};

using PowderElasticity = std::variant<DensityElasticity, PressureElasticity>;

} // namespace continuum
