#pragma once

#include <Eigen/Core>

/// Small vectors and constants of the grain library. SI units everywhere.
namespace dem {

using Vec3 = Eigen::Vector3d;

inline constexpr double pi = 3.14159265358979323846;

} // namespace dem
