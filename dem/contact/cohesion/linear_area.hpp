#pragma once

#include "dem/contact/contact_geometry.hpp"
#include "dem/material.hpp"
#include "dem/vec3.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace dem {

/// Cohesion energy density k times a contact area that grows linearly with the overlap:  F = -k A,
/// A = C R* d. Each area convention is a law of its own name, with the constant C:
///   sjkr2                4 pi   what LIGGGHTS computes, and the seed's runs (its "equivalent
///   radius" is 2 R*) linear_reduced       2 pi   the paper's formula read literally, with the
///   reduced radius linear_hertz_circle  pi     the circle of Hertz
/// At a tool R* is the grain's radius; sjkr2 then takes 2 pi, as LIGGGHTS does (half the limit of a
/// large partner). Acts while d > 0; no reach beyond contact, no hysteresis. With Hertz' K the
/// force vanishes at d = (C R* k / K)^2.
struct LinearArea {
  static constexpr int n_constants = 1;

  struct Convention {
    std::string_view name;
    double at_grain; ///< C between grains
    double at_wall;  ///< C at a tool
  };
  static constexpr std::array<Convention, 3> conventions{{{"sjkr2", 4.0 * pi, 2.0 * pi},
                                                          {"linear_reduced", 2.0 * pi, 2.0 * pi},
                                                          {"linear_hertz_circle", pi, pi}}};

  static bool knows(std::string_view name) {
    for (auto const& c : conventions)
      if (c.name == name)
        return true;
    return false;
  }

  template <class N> struct Constants {
    N slope; ///< k C R* [N/m]
  };

  static Constants<double> constants(PairMaterial const& pair, PairSize const& size,
                                     std::string_view name) {
    double factor = 0.0;
    for (auto const& c : conventions)
      if (c.name == name)
        factor = size.is_wall ? c.at_wall : c.at_grain;
    return {pair.interaction.cohesion_energy_density * factor * size.effective_radius};
  }

  /// Force along the normal [N], <= 0.
  template <class N> static N force(Constants<N> const& c, ContactGeometry<N> const& g) {
    return -c.slope * g.overlap;
  }

  /// -1/2 k C R* d^2 [J]
  static double energy(Constants<double> const& c, double overlap, double, double) {
    return -0.5 * c.slope * overlap * overlap;
  }
};

} // namespace dem
