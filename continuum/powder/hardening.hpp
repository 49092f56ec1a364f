#pragma once

#include "continuum/powder/dual.hpp"
#include "continuum/powder/piecewise_linear.hpp"

#include <cmath>
#include <string>
#include <variant>

namespace continuum {

/// Cam-Clay:  dp_c = p_c/(lambda - kappa) d eps_v^p, so p_c = p_c0 exp(eps_v^p/(lambda - kappa)).
/// Both indices on volumetric strain. Source: powder.md 1.4.
struct IndexHardening {
  double preconsolidation; ///< p_c0 at eps_v^p = 0 [Pa]
  double lambda;           ///< virgin index [-]
  double kappa;            ///< recompression index [-], in [0, lambda)

  template <class T> T operator()(T const& compaction, T const&) const {
    using std::exp;
    return preconsolidation * exp(compaction / T(lambda - kappa));
  }
  void validate(std::string const& name, double initial_density) const;
};

/// Heckel's line as a hardening curve:  p_c = p_c0 + p_y ln[(1 - D_0)/(1 - D)], p_y = 1/K of the
/// plot ln 1/(1 - D) = K P + A. It rises without bound as D -> 1: the solid is never reached.
struct HeckelHardening {
  double initial_pressure;  ///< p_c0 at D_0 [Pa]
  double yield_pressure;    ///< p_y [Pa], > 0
  double reference_density; ///< D_0 [-], in (0, 1)

  template <class T> T operator()(T const&, T const& density) const {
    using std::log;
    return initial_pressure + yield_pressure * log((1.0 - reference_density) / (1.0 - density));
  }
  void validate(std::string const& name, double initial_density) const;
};

/// A measured p_c(D), linear between its rows; beyond the last row (D_e, p_e) with the slope s
/// there it goes on as  p_c = p_e + s (1 - D_e) ln[(1 - D_e)/(1 - D)], smoothly to infinity as D
/// -> 1.
struct TabulatedHardening {
  PiecewiseLinear pressure; ///< p_c [Pa] over D [-]; at least two rows, rising, all D below 1

  template <class T> T operator()(T const&, T const& density) const {
    using std::log;
    auto const& end = pressure.rows.back();
    if (value_of(density) <= end.x)
      return pressure(density);
    auto const& before = pressure.rows[pressure.rows.size() - 2];
    double const slope = (end.value - before.value) / (end.x - before.x);
    return end.value + slope * (1.0 - end.x) * log((1.0 - end.x) / (1.0 - density));
  }
  void validate(std::string const& name, double initial_density) const;
};

using PowderHardening = std::variant<IndexHardening, HeckelHardening, TabulatedHardening>;

/// @throws InvalidInput unless D0 is in (0, 1)
void validate_initial_density(std::string const& name, double relative_density);

} // namespace continuum
