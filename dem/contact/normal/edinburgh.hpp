#pragma once

#include "dem/contact/contact_choice.hpp"
#include "dem/contact/contact_geometry.hpp"
#include "dem/contact/normal/hertz.hpp"
#include "dem/material.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace dem {

/// The Edinburgh elasto-plastic adhesive contact (EEPA) with n = 3/2 and the dashpot of Hertz:
///   F = max( min( k1 d^n, k2 (d^n - d_p^n) ), -k_adh d^chi ),   d_p^n = lambda d_m^n,
///   k2 = k1 / (1 - lambda),   k1 = 4/3 E* sqrt(R*)
/// where d_m is the largest overlap, the contact's memory. The adhesive branch begins at the
/// pull-off force F_min = 3/2 pi w a, a^2 = R* d_m, or at the middle of the unloading line
/// (d_min^n = d_p^n / 2) if that comes first: d_min^n = d_p^n - F_min / k2,
/// k_adh = F_min / d_min^chi. Friction is limited by mu (F + k_adh d^chi), the force measured from
/// the adhesive branch. Without a constant pull-off force f_0 (a cohesion law takes its place).
/// Source: Thakur, Morrissey, Sun, Chen and Ooi, Granular Matter 16 (2014) 383; Morrissey, thesis,
/// Edinburgh (2013). The contact patch `a` as the Hertz circle at d_m is our reading.
struct Edinburgh {
  static constexpr std::string_view name = "edinburgh";
  static constexpr bool has_memory = true; ///< d_m [m]
  static constexpr bool is_plastic = true;

  template <class N> struct Constants {
    N stiffness; ///< k1 [N/m^(3/2)]
    N ratio;     ///< lambda [1]
    N pull;      ///< 3/2 pi w sqrt(R*) [N/m^(1/2)]: F_min over sqrt(d_m)
    N exponent;  ///< chi [1]
    N damping;   ///< as Hertz [kg/s/m^(1/4)]
  };
  static constexpr int n_constants = 5;

  static Constants<double> constants(PairMaterial const& pair, PairSize const& size,
                                     ContactChoice const& choice) {
    auto const hertz = Hertz::constants(pair, size, choice);
    return {.stiffness = hertz.stiffness,
            .ratio = choice.plasticity_ratio,
            .pull = 1.5 * pi * pair.interaction.surface_energy * std::sqrt(size.effective_radius),
            .exponent = choice.adhesion_exponent,
            .damping = hertz.damping};
  }

  static double reach(Constants<double> const&) { return 0.0; }

  /// The unloading that belongs to d_m.
  template <class N> struct Unloading {
    N k2;   ///< [N/m^(3/2)]
    N end;  ///< d_p^n
    N turn; ///< d_min^n
    N pull; ///< F_min [N]
  };
  template <class N> static Unloading<N> unloading(Constants<N> const& c, N const& most) {
    N const root = square_root(most);
    N const k2 = c.stiffness / (N(1) - c.ratio);
    N const end = c.ratio * most * root;
    N const half = N(0.5f) * k2 * end;
    N const wanted = c.pull * root;
    N const pull = select(wanted < half, wanted, half);
    return {.k2 = k2, .end = end, .turn = end - pull / k2, .pull = pull};
  }

  /// Size of the adhesive branch at d [N]:  F_min (d / d_min)^chi, with y = d^n
  template <class N>
  static N adhesion(Constants<N> const& c, Unloading<N> const& line, N const& y) {
    N const ratio = y / larger(line.turn, N(1e-30f));
    return line.pull * power(larger(ratio, N(0)), c.exponent / N(1.5f));
  }

  template <class N>
  static NormalForce<N> force(Constants<N> const& c, ContactGeometry<N> const& g, N& most) {
    most = select(g.overlap > N(0), larger(most, g.overlap), N(0));
    Unloading<N> const line = unloading(c, most);
    N const y = larger(g.overlap, N(0)) * g.root_overlap;
    // At d = d_m this is the first loading, k1 d^n.
    N const elastic = line.k2 * (y - line.end);
    N const adhesive = adhesion(c, line, y);
    N const whole = select(y < line.turn, -adhesive, elastic);
    return {.elastic = select(g.overlap > N(0), whole, N(0)),
            .damping = -c.damping * square_root(g.root_overlap) * g.separation_velocity,
            .contact_root = g.root_overlap,
            .grip = select(y < line.turn, adhesive, line.pull)};
  }

  /// Energy lost as d_m grows [J]: what loading took less what unloading will give back.
  template <class N, class Cohesion>
  static N dissipated(Constants<N> const& c, N const& from, N const& to, Cohesion&&) {
    auto const lost = [&](N const& most) {
      return N(0.4f) * c.stiffness * most * most * square_root(most) - stored(c, most, most);
    };
    return select(to > from, lost(to) - lost(from), N(0));
  }

  /// Integral of F from 0 to d on the unloading line and its adhesive branch [J].
  template <class N> static N stored(Constants<N> const& c, N const& overlap, N const& most) {
    Unloading<N> const line = unloading(c, most);
    N const third = N(2) / N(3);
    N const y = overlap * square_root(overlap);
    N const d_turn = power(line.turn, third);
    N const d_low = select(y < line.turn, overlap, d_turn);
    N const low =
        adhesion(c, line, select(y < line.turn, y, line.turn)) * d_low / (c.exponent + N(1));
    auto const line_integral = [&](N const& d, N const& z) {
      return line.k2 * (N(0.4f) * d * z - line.end * d);
    };
    N const high = line_integral(overlap, y) - line_integral(d_turn, line.turn);
    return select(y < line.turn, N(0), high) - low;
  }

  static double energy(Constants<double> const& c, double overlap, double most) {
    return overlap > 0.0 ? stored(c, overlap, std::max(most, overlap)) : 0.0;
  }
  /// Its own adhesion needs no area.
  static std::pair<double, double> area_overlap(Constants<double> const&, double overlap, double) {
    return {overlap, 1.0};
  }
  /// dF/dd of unloading [N/m]:  3/2 k2 sqrt(d), the steepest of the law
  static double tangent(Constants<double> const& c, double overlap, double) {
    return 1.5 * c.stiffness / (1.0 - c.ratio) * std::sqrt(overlap);
  }
  template <class N> static N tangent_at(Constants<N> const& c, N const& contact_root) {
    return N(1.5f) * c.stiffness / (N(1) - c.ratio) * contact_root;
  }
  static double dashpot(Constants<double> const& c, double overlap, double) {
    return c.damping * std::sqrt(std::sqrt(std::max(overlap, 0.0)));
  }
};

} // namespace dem
