#pragma once

#include "dem/contact/contact_choice.hpp"
#include "dem/contact/contact_geometry.hpp"
#include "dem/material.hpp"
#include "dem/vec3.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace dem {

/// Adhesive contact of Johnson, Kendall and Roberts with the dashpot of Hertz. With the contact
/// radius a and the work of adhesion w:
///   d = a^2/R* - sqrt(2 pi w a / E*),    F = 4 E* a^3 / (3 R*) - sqrt(8 pi w E* a^3)
/// Touches at d = 0 and holds on while parting until d = -reach, where the pull-off branch ends.
/// Source: Johnson, Kendall and Roberts, Proc. R. Soc. A 324 (1971) 301; reach from dd/da = 0.
struct Jkr {
  static constexpr std::string_view name = "jkr";
  static constexpr bool has_memory = true; ///< 1 once the grains have touched, 0 before

  template <class N> struct Constants {
    N radius;    ///< R* [m]
    N modulus;   ///< E* [Pa]
    N adhesion;  ///< s = sqrt(2 pi w / E*)  [m^(1/2)]
    N zero_load; ///< sqrt(a) at d = 0:  (R* s)^(1/3)  [m^(1/2)]
    N reach;     ///< 3/4 (R* s^4 / 4)^(1/3): minus the smallest d on the branch [m]
    N damping;   ///< as Hertz [kg/s/m^(1/4)]
  };
  static constexpr int n_constants = 6;

  static Constants<double> constants(PairMaterial const& pair, PairSize const& size,
                                     ContactChoice const&) {
    double const stiffness = 2.0 * pair.effective_modulus * std::sqrt(size.effective_radius);
    double const s = std::sqrt(2.0 * pi * pair.interaction.surface_energy / pair.effective_modulus);
    return {.radius = size.effective_radius,
            .modulus = pair.effective_modulus,
            .adhesion = s,
            .zero_load = std::cbrt(size.effective_radius * s),
            .reach = 0.75 * std::cbrt(0.25 * size.effective_radius * s * s * s * s),
            .damping = -2.0 * std::sqrt(5.0 / 6.0) * pair.damping_ratio *
                       std::sqrt(stiffness * size.effective_mass)};
  }

  /// Distance [m] beyond touch at which the law still acts.
  static double reach(Constants<double> const& c) { return c.reach; }

  /// sqrt(a) from d: the larger root x of x^4/R* - s x - d = 0, by Newton from above, where the
  /// curve is convex and the iteration falls monotonically. (R* s)^(1/3) + (R* d)^(1/4) lies above
  /// the root for every d.
  template <class N> static N root_contact_radius(Constants<N> const& c, N const& overlap) {
    N x = c.zero_load + square_root(square_root(c.radius * larger(overlap, N(0))));
    for (int k = 0; k < 30; ++k) {
      N const x3 = x * x * x;
      N const slope = larger(N(4) * x3 / c.radius - c.adhesion, N(1e-12f));
      x = x - (x3 * x / c.radius - c.adhesion * x - overlap) / slope;
    }
    return x;
  }

  template <class N>
  static NormalForce<N> force(Constants<N> const& c, ContactGeometry<N> const& g, N& touched) {
    touched = select(g.overlap > N(0), N(1), select(g.overlap < -c.reach, N(0), touched));
    N const x = root_contact_radius(c, larger(g.overlap, -c.reach));
    N const a = x * x;
    N const elastic = c.modulus * (N(4) / N(3) * a * a * a / c.radius - N(2) * c.adhesion * a * x);
    auto const acts = touched > N(0.5f);
    return {.elastic = select(acts, elastic, N(0)),
            .damping = -c.damping * square_root(g.root_overlap) * g.separation_velocity,
            .contact_root = select(acts, a / square_root(c.radius), N(0))};
  }

  /// Integral of F dd along the branch, from a = 0 [J]; the energy of the parted grains is 0.
  static double energy(Constants<double> const& c, double overlap) {
    double const x = root_contact_radius(c, overlap);
    double const R = c.radius, s = c.adhesion;
    return c.modulus * (8.0 / 15.0 * std::pow(x, 10) / (R * R) -
                        4.0 / 3.0 * s * std::pow(x, 7) / R + 0.5 * s * s * std::pow(x, 4));
  }
  static double tangent(Constants<double> const& c, double overlap) {
    double const x = root_contact_radius(c, overlap);
    double const ratio = c.adhesion * c.radius / (x * x * x); // 4 at the end of the branch
    return 2.0 * c.modulus * x * x * std::abs(1.0 - 0.75 * ratio) /
           std::max(1.0 - 0.25 * ratio, 1e-3);
  }
  /// 2 E* a [N/m], without adhesion's share: what the viscous part of the bodies follows.
  template <class N> static N tangent_at(Constants<N> const& c, N const& contact_root) {
    return N(2) * c.modulus * square_root(c.radius) * contact_root;
  }
  static double dashpot(Constants<double> const& c, double overlap) {
    return c.damping * std::sqrt(std::sqrt(std::max(overlap, 0.0)));
  }
};

} // namespace dem
