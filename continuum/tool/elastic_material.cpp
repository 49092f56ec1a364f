#include "continuum/tool/elastic_material.hpp"

#include "continuum/expect.hpp"
#include "continuum/tool/quote.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace continuum {

void ElasticMaterial::validate(std::string const& name) const {
  VALIDATE(std::isfinite(young_modulus) && young_modulus > 0.0,
           name + ": Young's modulus = " + quote(young_modulus) +
               " Pa (a body that resists needs a positive one). Steel has 2.1e11 Pa; is the unit "
               "right?");
  VALIDATE(poisson_ratio > -1.0 && poisson_ratio < 0.5,
           name + ": Poisson's ratio = " + quote(poisson_ratio) +
               " (elastic energy is positive only between -1 and 0.5). Metals have 0.25 to 0.35?");
  auto const positive = [&](std::optional<double> const& strength, char const* what) {
    VALIDATE(!strength || (std::isfinite(*strength) && *strength > 0.0),
             name + ": " + what + " = " + quote(*strength) +
                 " Pa (a strength is positive). Leave it out if it is not known?");
  };
  positive(yield_strength, "yield strength");
  positive(fatigue_strength, "fatigue strength");
}

double ElasticMaterial::lame_lambda() const {
  return young_modulus * poisson_ratio / ((1.0 + poisson_ratio) * (1.0 - 2.0 * poisson_ratio));
}

double ElasticMaterial::shear_modulus() const {
  return young_modulus / (2.0 * (1.0 + poisson_ratio));
}

Eigen::Matrix3d ElasticMaterial::stress(Eigen::Matrix3d const& strain) const {
  return lame_lambda() * strain.trace() * Eigen::Matrix3d::Identity() +
         2.0 * shear_modulus() * strain;
}

double von_mises(Eigen::Matrix3d const& stress) {
  Eigen::Matrix3d const deviator = stress - stress.trace() / 3.0 * Eigen::Matrix3d::Identity();
  return std::sqrt(1.5) * deviator.norm();
}

Eigen::Vector3d principal_stresses(Eigen::Matrix3d const& stress) {
  // The iterative solver: the closed form loses digits where two principal stresses agree.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> const solver(stress, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().reverse();
}

} // namespace continuum
