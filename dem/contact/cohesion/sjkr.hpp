#pragma once

#include "dem/contact/contact_geometry.hpp"
#include "dem/material.hpp"
#include "dem/vec3.hpp"

#include <string_view>

namespace dem {

/// Cohesion energy density k times the disc in which the spheres intersect:
///   F = -k A,  A = pi [(Ri + Rj)^2 - r^2] [r^2 - (Ri - Rj)^2] / (4 r^2);   at a tool  A = pi d (2
///   Ri - d)
/// Source: LIGGGHTS' documentation of `cohesion sjkr`; the disc from Weisstein, "Sphere-Sphere
/// Intersection".
struct Sjkr {
  static constexpr int n_constants = 2;
  static bool knows(std::string_view name) { return name == "sjkr"; }

  template <class N> struct Constants {
    N density; ///< pi k [J/m^3]
    N wall;    ///< 1 at a tool, 0 between grains
  };

  static Constants<double> constants(PairMaterial const& pair, PairSize const& size,
                                     std::string_view) {
    return {.density = pi * pair.interaction.cohesion_energy_density,
            .wall = size.is_wall ? 1.0 : 0.0};
  }

  template <class N> static N force(Constants<N> const& c, ContactGeometry<N> const& g) {
    N const sum = g.radius_i + g.radius_j;
    N const difference = g.radius_i - g.radius_j;
    N const r = g.distance;
    // (Ri + Rj)^2 - r^2 through the overlap: the difference of squares would lose the small overlap
    // in float.
    N const disc = g.overlap * (sum + r) * (r * r - difference * difference) / (N(4) * r * r);
    N const wall_disc = g.overlap * (N(2) * g.radius_i - g.overlap);
    return -c.density * select(c.wall > N(0.5f), wall_disc, disc);
  }

  /// -k times the volume swept by the disc [J]: the antiderivative of A over d.
  static double energy(Constants<double> const& c, double d, double radius_i, double radius_j) {
    if (c.wall > 0.5)
      return -c.density * (radius_i * d * d - d * d * d / 3.0);
    double const s = radius_i + radius_j, s2 = s * s;
    double const q2 = (radius_i - radius_j) * (radius_i - radius_j);
    auto const antiderivative = [&](double r) {
      return (s2 + q2) * r - r * r * r / 3.0 + s2 * q2 / r;
    };
    return -0.25 * c.density * (antiderivative(s) - antiderivative(s - d));
  }
};

} // namespace dem
