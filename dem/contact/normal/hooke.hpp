#pragma once

#include "dem/contact/contact_choice.hpp"
#include "dem/contact/contact_geometry.hpp"
#include "dem/material.hpp"

#include <cmath>
#include <string_view>

namespace dem {

/// Linear spring and dashpot whose stiffness stores the same energy as Hertz at the characteristic
/// velocity V:
///   F = k d - c v_n,   k = 16/15 sqrt(R*) E* (15 m* V^2 / (16 sqrt(R*) E*))^(1/5),   c = -2 beta
///   sqrt(k m*)
/// Restitution is exactly e.  Source: Cundall and Strack, Geotechnique 29 (1979) 47; LIGGGHTS'
/// documentation of `model hooke` for k.
struct Hooke {
  static constexpr std::string_view name = "hooke";
  static constexpr bool has_memory = false;

  template <class N> struct Constants {
    N stiffness; ///< k [N/m]
    N damping;   ///< c [kg/s]
  };
  static constexpr int n_constants = 2;

  static double stiffness(PairMaterial const& pair, PairSize const& size,
                          ContactChoice const& choice) {
    double const root_modulus = std::sqrt(size.effective_radius) * pair.effective_modulus;
    double const v = choice.characteristic_velocity;
    return 16.0 / 15.0 * root_modulus *
           std::pow(15.0 * size.effective_mass * v * v / (16.0 * root_modulus), 0.2);
  }

  static Constants<double> constants(PairMaterial const& pair, PairSize const& size,
                                     ContactChoice const& choice) {
    double const k = stiffness(pair, size, choice);
    return {.stiffness = k,
            .damping = -2.0 * pair.damping_ratio * std::sqrt(k * size.effective_mass)};
  }

  static double reach(Constants<double> const&) { return 0.0; }

  template <class N>
  static NormalForce<N> force(Constants<N> const& c, ContactGeometry<N> const& g, N&) {
    return {.elastic = c.stiffness * g.overlap,
            .damping = -c.damping * g.separation_velocity,
            .contact_root = N(1)};
  }

  /// 1/2 k d^2 [J]
  static double energy(Constants<double> const& c, double overlap) {
    return 0.5 * c.stiffness * overlap * overlap;
  }
  static double tangent(Constants<double> const& c, double) { return c.stiffness; }
  template <class N> static N tangent_at(Constants<N> const& c, N const&) { return c.stiffness; }
  static double dashpot(Constants<double> const& c, double) { return c.damping; }
};

} // namespace dem
