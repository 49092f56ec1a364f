#pragma once

#include "continuum/powder/elasticity.hpp"
#include "continuum/powder/hardening.hpp"
#include "continuum/powder/powder_state.hpp"

#include <string>

namespace continuum {

/// Modified Cam-Clay with cohesion, associated:
///     F = q^2 + M^2 (p + c)(p - p_c) = 0,   d eps^p = dl dF/dsigma.
/// One smooth ellipse from p = -c to p = p_c. Elasticity and hardening choose the reading: with
/// PressureElasticity and IndexHardening it is Cam-Clay of soils (powder.md 1.4), with
/// DensityElasticity and a Heckel or tabulated p_c(D) a powder in a die.
/// Source: Roscoe and Burland (1968); Borja and Tamagnini (1998) for the finite-strain form.
struct ModifiedCamClay {
  double slope;                    ///< M [-], > 0: q/p where flow keeps the volume (c = 0)
  double cohesion = 0.0;           ///< c [Pa], >= 0: isotropic tension that is borne
  double initial_relative_density; ///< D_0 [-], in (0, 1)
  PowderElasticity elasticity;
  PowderHardening hardening;

  /// @throws InvalidInput for values without a law; the messages name the entry
  void validate(std::string const& name) const;

  double relative_density(PowderState const& state) const;       ///< D = D_0 exp(eps_v^p), unloaded
  double consolidation_pressure(PowderState const& state) const; ///< p_c [Pa]

  /// One implicit step; powder_law.hpp.
  PowderResult respond(PowderState const& old, Eigen::Vector3d const& trial_strain) const;
};

/// Stress ratio eta = q/p of Cam-Clay (c = 0) on the virgin line of uniaxial strain, constant nu
/// and K = p/kappa: the root of
///     eta (1 + nu)(1 - L)/[3 (1 - 2 nu)] + 3 eta L/(M^2 - eta^2) = 1,   L = 1 - kappa/lambda.
/// L = 1 is the rigid-plastic limit, eta = [sqrt(9 + 4 M^2) - 3]/2.
/// @param slope M > 0, plastic_share L in (0, 1], poisson_ratio nu
/// Source: powder.md 1.4; Wood (1990), ch. 10, for its derivation.
double virgin_stress_ratio(double slope, double plastic_share, double poisson_ratio);

/// K_0 = s_r/s_z of a stress ratio eta = q/p in die pressing:  (3 - eta)/(3 + 2 eta).
double lateral_ratio(double stress_ratio);

} // namespace continuum
