#pragma once

#include "continuum/powder/elasticity.hpp"
#include "continuum/powder/powder_state.hpp"

#include <string>

namespace continuum {

/// Which way plastic strain goes on the shear line and the transition, as slope -m_p/m_q there.
enum class ShearFlow {
  elliptic,  ///< Abaqus: G = sqrt[((p_a - p) tan b)^2 + (q/k)^2], k = 1 + a - a/cos b
  admissible ///< G = q + k ((p_a - p) tan b)^2/(2 D_c): the parabola that osculates that ellipse at
             ///< p_a. Its slope k tan^2 b (p_a - p)/D_c grows from 0 at p_a to k tan b at the apex,
             ///< associated there for a = 0: plastic work stays above d per unit shear (p > 0).
};

/// Density-dependent Drucker-Prager cap, Abaqus' form with K = 1. p, q positive in compression; d,
/// b, R, E, nu follow D = D_0 exp(eps_v^p), all at the END of the step:
///     D_c = d + p_a tan b,     p_a = (p_b - R d)/(1 + R tan b)
///     shear       q - p tan b - d = 0                                      p < p_a - a D_c sin b
///     transition  sqrt[(p - p_a)^2 + (q - (1 - a/cos b) D_c)^2] - a D_c = 0   up to p_a
///     cap         sqrt[(p - p_a)^2 + (R q/k)^2] - R D_c = 0                   p > p_a
///     cut-off     p + f d/tan b = 0
/// Cap associated, cut-off associated, shear and transition by ShearFlow.
/// Source: Abaqus theory manual 4.4.4; powder.md 1.1.
struct DruckerPragerCap {
  PiecewiseLinear cohesion;           ///< d [Pa] over D, >= 0
  PiecewiseLinear friction_angle;     ///< b [rad] over D, in (0, pi/2)
  PiecewiseLinear eccentricity;       ///< R [-] over D, > 0
  PiecewiseLinear hardening;          ///< p_b [Pa] over ln(D / hardening_reference_density)
  double hardening_reference_density; ///< [-]: D at which the table's strain is zero
  double transition = 0.0;            ///< a [-], in [0, cos b)
  double initial_relative_density;    ///< D_0 [-], in (0, 1)
  DensityElasticity elasticity;
  ShearFlow shear_flow = ShearFlow::elliptic;
  double tension_cut_off = 1.0; ///< f [-], in (0, 1]: share of the apex d/tan b; 1 is the apex

  /// @throws InvalidInput for values without a law; the messages name the entry
  void validate(std::string const& name) const;

  double relative_density(PowderState const& state) const; ///< D = D_0 exp(eps_v^p), unloaded

  /// One implicit step; powder_law.hpp.
  PowderResult respond(PowderState const& old, Eigen::Vector3d const& trial_strain) const;
};

/// The surfaces at one density; T is double or a Dual.
template <class T> struct CapShape {
  T d, tan_b, cos_b, R, p_b;
  T p_a, D_c;  ///< [Pa]: cap's middle, height of the shear line there
  T k;         ///< 1 + a - a/cos b [-]
  T p_shear;   ///< [Pa]: where the shear line passes into the transition
  T p_tension; ///< [Pa]: -f d/tan b
};

/// @param compaction  eps_v^p [-]
CapShape<double> cap_shape(DruckerPragerCap const& law, double compaction);

/// Die pressing at zero radial plastic strain and a = 0, flow on the cap with eps_q^p = 2/3
/// eps_v^p:
///     q* = D_c/sqrt(1 + 9 R^2/4),  p* = p_a + 3/2 R^2 q*,  s_z* = p_a + D_c sqrt(R^2 + 4/9),
///     s_r* = p* - q*/3.   Compression positive. Source: powder.md 1.2.
struct DieStress {
  double p, q, axial, radial; ///< [Pa]
};
DieStress rigid_plastic_die_stress(CapShape<double> const& shape);

/// Inverse of those:  p_a from a measured (p*, q*), with d and tan b of the shear line [Pa]:
///     p_a = {-(3 q + 4 d t) + sqrt[9 q^2 + 24 d q t + 8 (3 p q + 2 q^2) t^2]}/(4 t^2).
/// Source: Cunningham et al. (2004), Han et al. (2008); powder.md 1.1.
double cap_middle(double p, double q, double cohesion, double tan_friction);

/// Plastic work per unit shear strain on the shear line and the transition, (p m_p + q m_q)/m_q
/// [Pa], where it is least, and the range of p where it is negative. Abaqus' potential has such a
/// range when p_a tan b > 2 (1 + sqrt 2) d (a = 0): there plastic flow would GIVE energy.
struct ShearDissipation {
  double least;               ///< [Pa]
  double at_pressure;         ///< p of the least [Pa]
  double negative_from = 0.0; ///< range of p with negative work [Pa]; empty if both agree
  double negative_to = 0.0;
  bool is_admissible() const { return least >= 0.0; }
};
ShearDissipation dissipation(DruckerPragerCap const& law, double compaction);

} // namespace continuum
