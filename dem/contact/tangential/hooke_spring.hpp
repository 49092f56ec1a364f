#pragma once

#include "dem/contact/contact_choice.hpp"
#include "dem/contact/contact_geometry.hpp"
#include "dem/contact/normal/hooke.hpp"
#include "dem/material.hpp"

#include <cmath>
#include <string_view>

namespace dem {

/// Linear tangential spring as stiff as the normal one, with Coulomb's limit and a dashpot:  k_t =
/// k_n,  c_t = c_n. Source: LIGGGHTS' documentation of `model hooke` with `tangential history`.
struct HookeSpring {
  static constexpr std::string_view name = "hooke_spring";
  static constexpr bool has_spring = true;
  static constexpr int n_constants = 3;

  template <class N> struct Constants {
    N stiffness; ///< [N/m]
    N damping;   ///< [kg/s]
    N friction;  ///< mu
  };

  static Constants<double> constants(PairMaterial const& pair, PairSize const& size,
                                     ContactChoice const& choice) {
    auto const normal = Hooke::constants(pair, size, choice);
    return {.stiffness = normal.stiffness,
            .damping = choice.tangential_damping ? normal.damping : 0.0,
            .friction = pair.interaction.static_friction};
  }

  template <class N> static N stiffness(Constants<N> const& c, N const&) { return c.stiffness; }
  template <class N> static N dashpot(Constants<N> const& c, N const&) { return c.damping; }
};

} // namespace dem
