#pragma once

#include "dem/contact/contact_choice.hpp"
#include "dem/contact/contact_geometry.hpp"
#include "dem/material.hpp"

#include <array>
#include <cmath>
#include <string_view>

namespace dem {

/// Hertz contact with the dashpot of Tsuji:
///   F = 4/3 E* sqrt(R* d) d - gamma v_n,   gamma = -2 sqrt(5/6) beta sqrt(S_n m*),   S_n = 2 E*
///   sqrt(R* d)
/// Holds while the contact radius is small against the grain radius.
/// Source: Johnson, Contact Mechanics (1985), 4.22-4.24; Tsuji, Tanaka and Ishida, Powder Technol.
/// 71 (1992) 239.
struct Hertz {
  static constexpr std::string_view name = "hertz";
  static constexpr bool has_memory = false;

  template <class N> struct Constants {
    N stiffness; ///< 4/3 E* sqrt(R*)  [N/m^(3/2)]
    N damping;   ///< -2 sqrt(5/6) beta sqrt(2 E* sqrt(R*) m*)  [kg/s/m^(1/4)]
  };
  static constexpr int n_constants = 2;

  static Constants<double> constants(PairMaterial const& pair, PairSize const& size,
                                     ContactChoice const&) {
    double const stiffness = 2.0 * pair.effective_modulus * std::sqrt(size.effective_radius);
    return {.stiffness = 2.0 / 3.0 * stiffness,
            .damping = -2.0 * std::sqrt(5.0 / 6.0) * pair.damping_ratio *
                       std::sqrt(stiffness * size.effective_mass)};
  }

  /// Distance [m] beyond touch at which the law still acts.
  static double reach(Constants<double> const&) { return 0.0; }

  template <class N>
  static NormalForce<N> force(Constants<N> const& c, ContactGeometry<N> const& g, N&) {
    return {.elastic = c.stiffness * g.root_overlap * g.overlap,
            .damping = -c.damping * square_root(g.root_overlap) * g.separation_velocity,
            .contact_root = g.root_overlap};
  }

  /// Stored energy [J]:  2/5 K d^(5/2)
  static double energy(Constants<double> const& c, double overlap) {
    return 0.4 * c.stiffness * overlap * overlap * std::sqrt(overlap);
  }
  /// Tangent stiffness dF/dd [N/m]:  3/2 K sqrt(d)
  static double tangent(Constants<double> const& c, double overlap) {
    return 1.5 * c.stiffness * std::sqrt(overlap);
  }
  /// The same from the contact root, for packs.
  template <class N> static N tangent_at(Constants<N> const& c, N const& contact_root) {
    return N(1.5f) * c.stiffness * contact_root;
  }
  /// Dashpot coefficient [kg/s]
  static double dashpot(Constants<double> const& c, double overlap) {
    return c.damping * std::sqrt(std::sqrt(overlap));
  }
};

} // namespace dem
