#pragma once

#include "dem/contact/contact_choice.hpp"
#include "dem/contact/contact_geometry.hpp"
#include "dem/contact/normal/hertz.hpp"
#include "dem/material.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace dem {

/// Elasto-plastic contact of Thornton and Ning, with the dashpot of Hertz. Once the pressure in the
/// middle of the contact reaches the yield pressure p_y it rises no further:
///   F = K d^(3/2)                      d <= d_y = (pi p_y / 2 E*)^2 R*,   K = 4/3 E* sqrt(R*)
///   F = F_y + pi p_y R* (d - d_y)      d >  d_y
/// Unloading from (d_m, F_m) is that of Hertz with the flattened radius R_p = 4 E* a_m^3 / (3 F_m),
/// a_m^2 = R* d_m, which in h = d_m - d_p = F_m / (K sqrt(d_m)), with d_p where the force ends, is
///   F = F_m x^(3/2),  a^2 = R* d_m x,  x = (d - d_p) / h
/// Reloading goes back the same way to d_m, the contact's memory; grains that part forget it.
/// Laws that scale with the contact area see d_m x in the place of d.
/// Source: Thornton and Ning, Powder Technol. 99 (1998) 154, without its adhesion.
struct ThorntonNing {
  static constexpr std::string_view name = "thornton_ning";
  static constexpr bool has_memory = true; ///< d_m [m]
  static constexpr bool is_plastic = true;

  template <class N> struct Constants {
    N stiffness;     ///< K [N/m^(3/2)]
    N yield_overlap; ///< d_y [m]
    N slope;         ///< pi p_y R* [N/m]
    N damping;       ///< as Hertz [kg/s/m^(1/4)]
  };
  static constexpr int n_constants = 4;

  static Constants<double> constants(PairMaterial const& pair, PairSize const& size,
                                     ContactChoice const& choice) {
    auto const hertz = Hertz::constants(pair, size, choice);
    double const ratio = 0.5 * pi * choice.yield_pressure / pair.effective_modulus;
    return {.stiffness = hertz.stiffness,
            .yield_overlap = ratio * ratio * size.effective_radius,
            .slope = pi * choice.yield_pressure * size.effective_radius,
            .damping = hertz.damping};
  }

  static double reach(Constants<double> const&) { return 0.0; }

  /// The first loading: F(d_m) [N] and its slope [N/m].
  template <class N> struct Loading {
    N force, slope, root; ///< root = sqrt(d_m)
  };
  template <class N> static Loading<N> loading(Constants<N> const& c, N const& most) {
    N const root = square_root(most);
    N const root_yield = square_root(c.yield_overlap);
    auto const yields = most > c.yield_overlap;
    return {.force = select(yields,
                            c.stiffness * c.yield_overlap * root_yield +
                                c.slope * (most - c.yield_overlap),
                            c.stiffness * most * root),
            .slope = select(yields, c.slope, N(1.5f) * c.stiffness * root),
            .root = root};
  }

  template <class N>
  static NormalForce<N> force(Constants<N> const& c, ContactGeometry<N> const& g, N& most) {
    most = select(g.overlap > N(0), larger(most, g.overlap), N(0));
    Loading<N> const at = loading(c, larger(most, N(1e-30f)));
    N const range = at.force / (c.stiffness * at.root); // h
    N const x = larger(N(1) - (most - g.overlap) / range, N(0));
    N const root_x = square_root(x);
    N const contact_root = at.root * root_x;
    return {.elastic = select(g.overlap > N(0), at.force * x * root_x, N(0)),
            .damping = -c.damping * square_root(contact_root) * g.separation_velocity,
            .contact_root = contact_root};
  }

  /// Energy lost as d_m grows from `from` to `to` [J], by the midpoint rule: per length of d_m
  ///   F_m - d(2/5 F_m h)/dd_m + F_c (1 - (h/d_m + dh/dd_m) / 2),
  /// with F_c the cohesion at d_m, linear in the area; 0 below yield.
  /// @param cohesion  F_c of an overlap [N], <= 0
  template <class N, class Cohesion>
  static N dissipated(Constants<N> const& c, N const& from, N const& to, Cohesion&& cohesion) {
    N const most = larger(N(0.5f) * (from + to), N(1e-30f));
    Loading<N> const at = loading(c, most);
    N const inverse = N(1) / (c.stiffness * at.root);
    N const range = at.force * inverse;
    N const half = N(0.5f) * at.force / most;
    N const normal = at.force - N(0.4f) * range * (N(2) * at.slope - half);
    N const growth = (at.slope - half) * inverse; // dh/dd_m
    N const adhesive = cohesion(most) * (N(1) - N(0.5f) * (range / most + growth));
    return select(most > c.yield_overlap, (normal + adhesive) * (to - from), N(0));
  }

  /// What unloading gives back [J]:  2/5 F_m h x^(5/2)
  static double energy(Constants<double> const& c, double overlap, double most) {
    auto const [force, range, x] = unloading(c, overlap, most);
    return 0.4 * force * range * x * x * std::sqrt(x);
  }
  /// Overlap that has the contact's area, d_m x [m], and the length of unloading over it, h / d_m.
  static std::pair<double, double> area_overlap(Constants<double> const& c, double overlap,
                                                double most) {
    auto const [force, range, x] = unloading(c, overlap, most);
    double const d = std::max(most, overlap);
    return {d * x, range / d};
  }
  /// dF/dd of unloading [N/m]:  3/2 K sqrt(d_m x), the steepest of the law
  static double tangent(Constants<double> const& c, double overlap, double most) {
    return 1.5 * c.stiffness * std::sqrt(area_overlap(c, overlap, most).first);
  }
  /// The same, as the law's own stiffness against a small motion, from the contact root.
  template <class N> static N tangent_at(Constants<N> const& c, N const& contact_root) {
    return N(1.5f) * c.stiffness * contact_root;
  }
  static double dashpot(Constants<double> const& c, double overlap, double most) {
    return c.damping * std::sqrt(std::sqrt(area_overlap(c, overlap, most).first));
  }

private:
  struct Unloading {
    double force, range, x;
  };
  static Unloading unloading(Constants<double> const& c, double overlap, double most) {
    double const d = std::max({most, overlap, 1e-30});
    auto const at = loading(c, d);
    double const range = at.force / (c.stiffness * at.root);
    return {at.force, range, std::max(0.0, 1.0 - (d - overlap) / range)};
  }
};

} // namespace dem
