#pragma once

#include "dem/contact/contact_choice.hpp"
#include "dem/contact/contact_geometry.hpp"
#include "dem/material.hpp"

#include <cmath>
#include <string_view>

namespace dem {

/// No-slip stiffness of Mindlin in total form, with history, Coulomb's limit and a dashpot:
///   k = 8 G* sqrt(R* d),   c = -2 sqrt(5/6) beta sqrt(k m*)
/// Source: Mindlin, J. Appl. Mech. 16 (1949) 259; Di Renzo and Di Maio (2004).
struct Mindlin {
  static constexpr std::string_view name = "mindlin";
  static constexpr bool has_spring = true;
  static constexpr int n_constants = 3;

  template <class N> struct Constants {
    N stiffness; ///< 8 G* sqrt(R*)  [N/m^(3/2)]
    N damping;   ///< -2 sqrt(5/6) beta sqrt(8 G* sqrt(R*) m*)  [kg/s/m^(1/4)]
    N friction;  ///< mu
  };

  static Constants<double> constants(PairMaterial const& pair, PairSize const& size,
                                     ContactChoice const& choice) {
    double const stiffness = 8.0 * pair.effective_shear_modulus * std::sqrt(size.effective_radius);
    double const damping = -2.0 * std::sqrt(5.0 / 6.0) * pair.damping_ratio *
                           std::sqrt(stiffness * size.effective_mass);
    return {.stiffness = stiffness,
            .damping = choice.tangential_damping ? damping : 0.0,
            .friction = pair.interaction.static_friction};
  }

  /// Stiffness [N/m] and dashpot [kg/s] of the present contact; `root` is sqrt(d).
  template <class N> static N stiffness(Constants<N> const& c, N const& root) {
    return c.stiffness * root;
  }
  template <class N> static N dashpot(Constants<N> const& c, N const& root) {
    return c.damping * square_root(root);
  }
};

} // namespace dem
