#pragma once

#include "tests/diagnosis/hide/effects.hpp"

namespace hidden {

constexpr double MPa = 1e6, mm = 1e-3, kN = 1e3;

/// The seed's MgO/Al2O3 granules, as numbers of a bed. Source: full-size DEM runs.
struct Powder {
  double young_modulus = 1.95e9; ///< E [Pa]; K = 4.3e8 Pa at 1375 MPa, proportional
  double cohesion_density = 3e6; ///< CED [J/m^3]; S = 0.85e7 Pa E / 1375 MPa + 2.5 CED
  double onset = 0.633;          ///< phi_c [1]
  double exponent = 1.6;         ///< n [1]
  double radial_ratio = 0.51;    ///< [1], radial over axial stress
  double wall_friction = 0.205;  ///< [1], gives a lower punch 0.86 of the upper at the peak
  double recovery = 0.859;       ///< [1], share of the way back to the onset, as strain
  double curvature = 3.05;       ///< b [1] of the unloading
  double residual = 0.03;        ///< [1], radial pressure that stays, of the largest
  double wall_stiffness = 4e11;  ///< [Pa/m] at 30 MPa, shear of the wall layer, ~ p^0.75
  static constexpr double density = 1.0 / (0.8 / 3500.0 + 0.2 / 3000.0); ///< of the solid [kg/m^3]
};

/// The bed's law, stress as the free variable, so that history is one number, the largest stress:
///   first loading  s = K x^n (1 + multi-contact) - S x,     phi = phi_c(s) + x
///   below s_m      ln(phi_m / phi) = r ln(phi_m / phi_c) (1 - ln(1 + (e^b - 1) s / s_m) / b)
/// In logarithmic strain, as full-size grains unloaded from different gaps fall on each other.
class BedLaw {
public:
  BedLaw(Powder const& powder, Effects const& effects);

  /// Solid fraction in first loading. @param stress  axial [Pa]
  double loaded(double stress) const;
  /// @param largest  so far [Pa]; @param densest  loaded(largest)
  double solid_fraction(double stress, double largest, double densest) const;
  /// Proportional in loading; in unloading a part of the largest stays.
  double radial(double stress, double largest) const;
  /// Coefficient of friction on the wall. @param depth  0 at the upper punch, 1 at the lower
  double friction(double depth, double radial_pressure) const;
  /// Ejection: what the residual pressure alone holds.
  double residual_radial(double largest) const { return residual_ * ratio_ * largest; }

private:
  double densification(double stress) const;
  double onset(double stress) const;
  double stiffness_, cohesion_, onset_, exponent_, ratio_, friction_, recovery_, curvature_,
      residual_;
  Effects effects_;
};

} // namespace hidden
