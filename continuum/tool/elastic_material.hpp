#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>

namespace continuum {

/// Isotropic linear elasticity at small strain:  sigma = lambda tr(eps) I + 2 G eps.
struct ElasticMaterial {
  double young_modulus;                        ///< E [Pa], > 0
  double poisson_ratio;                        ///< nu [-], in (-1, 0.5)
  std::optional<double> yield_strength = {};   ///< [Pa], > 0; von Mises stress is compared with it
  std::optional<double> fatigue_strength = {}; ///< [Pa], > 0; amplitude that a tool bears for good

  /// @param name  what messages call the material
  /// @throws InvalidInput if the energy is not positive definite or a strength is not positive
  void validate(std::string const& name) const;

  double lame_lambda() const;   ///< E nu / ((1 + nu)(1 - 2 nu)) [Pa]
  double shear_modulus() const; ///< G = E / (2 (1 + nu)) [Pa]

  /// @param strain  symmetric [-]
  /// @return        Cauchy stress [Pa], tension positive
  Eigen::Matrix3d stress(Eigen::Matrix3d const& strain) const;
};

/// sqrt(3/2 s:s), s the deviator of the stress [Pa].
double von_mises(Eigen::Matrix3d const& stress);

/// Eigenvalues of a symmetric stress [Pa], largest (tension) first.
Eigen::Vector3d principal_stresses(Eigen::Matrix3d const& stress);

} // namespace continuum
