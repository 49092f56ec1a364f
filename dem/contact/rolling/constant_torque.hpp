#pragma once

#include "dem/contact/contact_geometry.hpp"
#include "dem/material.hpp"

#include <string_view>

namespace dem {

/// Constant directional torque against the relative rolling spin:
///   M = -mu_r R* F_el w/|w|,   w = (w_i - w_j) without its part along the normal,   F_el the
///   elastic normal force
/// on grain i, and the opposite on j.
/// Source: Zhou et al., Physica A 269 (1999) 536; Ai et al., Powder Technol. 206 (2011) 269, model
/// A.
struct ConstantTorque {
  static constexpr std::string_view name = "constant_torque";
  static constexpr bool resists = true;
  static constexpr int n_constants = 1;

  template <class N> struct Constants {
    N lever; ///< mu_r R* [m]
  };

  static Constants<double> constants(PairMaterial const& pair, PairSize const& size) {
    return {pair.interaction.rolling_friction * size.effective_radius};
  }

  template <class N>
  static Triple<N> torque(Constants<N> const& c, N const& elastic_force, Triple<N> const& normal,
                          Triple<N> const& relative_spin) {
    Triple<N> const rolling = relative_spin - dot(relative_spin, normal) * normal;
    N const rate = square_root(dot(rolling, rolling));
    return (-c.lever * elastic_force / larger(rate, N(1e-12f))) * rolling;
  }
};

} // namespace dem
