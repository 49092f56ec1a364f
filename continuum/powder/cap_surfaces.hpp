#pragma once

#include "continuum/powder/cap_model.hpp"
#include "continuum/powder/return_map.hpp"

#include <array>
#include <cmath>

namespace continuum {

/// The cap model as the return mapping sees it; formulas in cap_model.hpp.
struct CapSurfaces {
  DruckerPragerCap const& law;

  template <class T> T density_at(T const& compaction) const {
    using std::exp;
    return law.initial_relative_density * exp(compaction);
  }
  double density(double compaction) const { return density_at(compaction); }

  template <class T> StressPair<T> elastic(T const& v, T const& q, T const& compaction) const {
    return law.elasticity(v, q, density_at(compaction));
  }

  template <class T> CapShape<T> shape(T const& compaction) const {
    using std::cos, std::sqrt, std::tan;
    T const density = density_at(compaction);
    T const d = law.cohesion(density), b = law.friction_angle(density);
    T const R = law.eccentricity(density), t = tan(b), c = cos(b);
    T const p_b = law.hardening(
        compaction + std::log(law.initial_relative_density / law.hardening_reference_density));
    T const p_a = (p_b - R * d) / (1.0 + R * t), D_c = d + p_a * t;
    double const a = law.transition;
    return {.d = d,
            .tan_b = t,
            .cos_b = c,
            .R = R,
            .p_b = p_b,
            .p_a = p_a,
            .D_c = D_c,
            .k = 1.0 + a - a / c,
            .p_shear = p_a - a * D_c * t * c,
            .p_tension = -law.tension_cut_off * d / t};
  }

  template <class T>
  return_map::Face<T> face(PowderSurface surface, T const& p, T const& q,
                           T const& compaction) const {
    using std::sqrt;
    auto const s = shape(compaction);
    if (surface == PowderSurface::tension)
      return {s.p_tension - p, T(-1.0), T(0.0)};
    if (surface == PowderSurface::cap) {
      T const x = p - s.p_a, y = s.R * q / s.k, radius = sqrt(x * x + y * y);
      return {radius - s.R * s.D_c, x / radius, s.R * y / (s.k * radius)};
    }
    auto const [flow_p, flow_q] = shear_flow(s, p, q);
    if (surface == PowderSurface::shear)
      return {q - p * s.tan_b - s.d, flow_p, flow_q};
    double const a = law.transition;
    T const x = p - s.p_a, y = q - (1.0 - a / s.cos_b) * s.D_c;
    return {sqrt(x * x + y * y) - a * s.D_c, flow_p, flow_q};
  }

  template <class T>
  std::array<T, 2> shear_flow(CapShape<T> const& s, T const& p, T const& q) const {
    using std::sqrt;
    T const x = (s.p_a - p) * s.tan_b;
    if (law.shear_flow == ShearFlow::admissible)
      return {-s.k * x * s.tan_b / s.D_c, T(1.0)};
    T const y = q / s.k, G = sqrt(x * x + y * y);
    return {-x * s.tan_b / G, y / (s.k * G)};
  }

  template <class T> std::array<T, 2> edge(T const& p, T const& q, T const& compaction) const {
    auto const s = shape(compaction);
    return {p - s.p_tension, q - s.p_tension * s.tan_b - s.d};
  }

  /// q on the shear line or the transition, at p <= p_a.
  double height(CapShape<double> const& s, double p) const {
    if (p <= s.p_shear)
      return s.d + p * s.tan_b;
    double const a = law.transition, x = p - s.p_a;
    return (1.0 - a / s.cos_b) * s.D_c + std::sqrt(std::max(0.0, a * a * s.D_c * s.D_c - x * x));
  }

  double yield(double p, double q, double compaction) const;
  std::array<PowderSurface, 5> candidates(double p, double q, double compaction) const;
  bool admits(PowderSurface surface, double p, double q, double compaction,
              return_map::PlasticStep const& flow) const;
};

} // namespace continuum
