#pragma once

#include "continuum/tool/elastic_tool.hpp"
#include "continuum/verification/lame_tube.hpp"

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

using Tube = continuum::verification::LameTube;

/// u_z = 0 on both ends.
inline continuum::Supports plane_strain() {
  return {.surfaces = {{"bottom", {false, false, true}}, {"top", {false, false, true}}},
          .in_plane = continuum::Supports::InPlane::pinned};
}

} // namespace tools
