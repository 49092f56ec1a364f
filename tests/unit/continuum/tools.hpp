#pragma once

#include "continuum/tool/elastic_tool.hpp"

#include <Eigen/Core>

#include <cmath>
#include <random>

/// Small tools for tests, and the closed forms they are held against.
namespace tools {

inline constexpr double a = 11.025e-3, b = 30e-3; // the seed press's bore, its die's outside [m]
inline constexpr continuum::ElasticMaterial steel{.young_modulus = 210e9, .poisson_ratio = 0.3};

inline continuum::ToolMesh small_die() {
  return continuum::ToolMesh::die({.bore_radius = a, .outer_radius = b, .height = 12e-3},
                                  {.around = 16, .through_wall = 2, .along = 3});
}
inline continuum::ToolMesh small_punch(continuum::PunchPlace place = continuum::PunchPlace::lower) {
  return continuum::ToolMesh::punch({.radius = a, .length = 50e-3, .place = place},
                                    {.around = 16, .rings = 2, .along = 3});
}

inline Eigen::Matrix3Xd random_forces(Eigen::Index n, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> force(-1.0, 1.0);
  return Eigen::Matrix3Xd::NullaryExpr(3, n, [&] { return force(generator); });
}

inline double radial(Eigen::Vector3d const& x, Eigen::Vector3d const& u) {
  return x.head<2>().dot(u.head<2>()) / x.head<2>().norm();
}

/// Lame's tube in plane strain under inner and outer pressure.
struct Tube {
  double inner, outer;                   ///< [m]
  double inner_pressure, outer_pressure; ///< [Pa]
  continuum::ElasticMaterial material;

  /// (1 + nu)/E [ (1 - 2 nu) A r + B / r ],  sigma_r,t = A -+ B / r^2,
  /// A = (p_i r_i^2 - p_o r_o^2) / (r_o^2 - r_i^2),  B = (p_i - p_o) r_i^2 r_o^2 / (r_o^2 - r_i^2)
  double displacement(double r) const {
    double const nu = material.poisson_ratio;
    return (1.0 + nu) / material.young_modulus * ((1.0 - 2.0 * nu) * mean() * r + shear() / r);
  }
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

/// u_z = 0 on both ends.
inline continuum::Supports plane_strain() {
  return {.surfaces = {{"bottom", {false, false, true}}, {"top", {false, false, true}}},
          .in_plane = continuum::Supports::InPlane::pinned};
}

} // namespace tools
