#pragma once

#include "continuum/powder/dual.hpp"

#include <cstddef>
#include <span>

/// Pressure-density curves of pressing, and their fits. P is pressure [Pa], D relative density.
namespace continuum {

/// Heckel:  ln 1/(1 - D) = K P + A.   P_y = 1/K is the mean yield pressure; in-die densities
/// contain elastic strain, so their P_y is lower than out-of-die. Source: Heckel (1961), Trans.
/// Metall. Soc. AIME 221, 671.
struct Heckel {
  double slope;     ///< K [1/Pa]
  double intercept; ///< A [-]

  double density(double pressure) const;
  double pressure(double density) const;
  double yield_pressure() const { return 1.0 / slope; } ///< P_y [Pa]
};

/// Kawakita:  C = 1 - D_0/D = a b P/(1 + b P).   a is the limit of C, about the initial porosity;
/// 1/b the pressure of C = a/2.
/// Source: Kawakita and Luedde (1971), Powder Technol. 4, 61.
struct Kawakita {
  double a;               ///< [-]
  double b;               ///< [1/Pa]
  double initial_density; ///< D_0 [-]

  double density(double pressure) const;
  double pressure(double density) const;
};

/// Cooper and Eaton:  (1/D_0 - 1/D)/(1/D_0 - 1) = a_1 exp(-k_1/P) + a_2 exp(-k_2/P), k_1 <= k_2:
/// large voids by rearrangement, then small ones by fragmentation or flow; a_1 + a_2 = 1 if the two
/// fill all.  Source: Cooper and Eaton (1962), J. Am. Ceram. Soc. 45, 97.
struct CooperEaton {
  double a_1, k_1;        ///< [-], [Pa]
  double a_2, k_2;        ///< [-], [Pa]
  double initial_density; ///< D_0 [-]

  double density(double pressure) const;
};

struct PressureRange {
  double from, to; ///< [Pa]
};

/// A fit by least squares of the DENSITY, which is what is measured and scatters; a straight line
/// in the law's own coordinates would weigh the last points without reason.
template <class Curve> struct CurveFit {
  Curve curve;
  Curve standard_error; ///< of each parameter, in its member; the given D_0 has none
  double residual;      ///< standard deviation of D about the curve [-], n - n_parameters
  std::size_t n_points; ///< that were used
  PressureRange range;  ///< of those points [Pa]
};

/// @param pressure, density  of equal length, P >= 0 [Pa], D in (0, 1)
/// @param range              points outside are left out
/// @throws InvalidInput for data without a fit: too few points, D outside (0, 1), D_0 not below D;
///         SolverFailure if the data do not determine the parameters
CurveFit<Heckel> fit_heckel(std::span<double const> pressure, std::span<double const> density,
                            PressureRange const& range);
CurveFit<Kawakita> fit_kawakita(std::span<double const> pressure, std::span<double const> density,
                                PressureRange const& range, double initial_density);
CurveFit<CooperEaton> fit_cooper_eaton(std::span<double const> pressure,
                                       std::span<double const> density, PressureRange const& range,
                                       double initial_density);

} // namespace continuum
