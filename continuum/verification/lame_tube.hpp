#pragma once

#include "continuum/tool/elastic_material.hpp"

#include <Eigen/Core>

namespace continuum::verification {

/// Lame's tube in plane strain under inner and outer pressure.
struct LameTube {
  double inner, outer;                   ///< radii [m]
  double inner_pressure, outer_pressure; ///< [Pa]
  ElasticMaterial material;

  /// u_r(r) [m] = (1 + nu)/E [ (1 - 2 nu) A r + B / r ],
  /// A = (p_i r_i^2 - p_o r_o^2) / (r_o^2 - r_i^2),  B = (p_i - p_o) r_i^2 r_o^2 / (r_o^2 - r_i^2)
  double displacement(double r) const {
    double const nu = material.poisson_ratio;
    return (1.0 + nu) / material.young_modulus * ((1.0 - 2.0 * nu) * mean() * r + shear() / r);
  }
  /// sigma_r,t = A -+ B / r^2, sigma_z = 2 nu A, at a position [m], in Cartesian components [Pa].
  Eigen::Matrix3d stress(Eigen::Vector3d const& x) const {
    double const r = x.head<2>().norm();
    Eigen::Vector3d const er(x.x() / r, x.y() / r, 0.0), et(-er.y(), er.x(), 0.0);
    Eigen::Vector3d const ez = Eigen::Vector3d::UnitZ();
    return (mean() - shear() / (r * r)) * er * er.transpose() +
           (mean() + shear() / (r * r)) * et * et.transpose() +
           2.0 * material.poisson_ratio * mean() * ez * ez.transpose();
  }

private:
  double ring() const { return outer * outer - inner * inner; }
  double mean() const {
    return (inner_pressure * inner * inner - outer_pressure * outer * outer) / ring();
  }
  double shear() const {
    return (inner_pressure - outer_pressure) * inner * inner * outer * outer / ring();
  }
};

} // namespace continuum::verification
