#include "continuum/powder/spatial_tangent.hpp"

#include <cmath>

namespace continuum {
namespace {

/// (sigma_a - sigma_b)/(b_a - b_b). Below this distance of the strains the limit is better than the
/// quotient, whose digits cancel; there the two differ by about the distance itself.
double divided_difference(Eigen::Vector3d const& b, PowderResponse const& response, int i, int j) {
  constexpr double close = 1e-7;
  auto const& D = response.tangent;
  if (std::abs(b[i] - b[j]) < close * b[i])
    return (D(i, i) - D(i, j) + D(j, j) - D(j, i)) / (2.0 * (b[i] + b[j]));
  return (response.stress[i] - response.stress[j]) / (b[i] - b[j]);
}

/// Kronecker product: turns a row-major 3 x 3 from principal into fixed axes.
SpatialTangent turning(Eigen::Matrix3d const& axes) {
  SpatialTangent result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      result.block<3, 3>(3 * i, 3 * j) = axes(i, j) * axes;
  return result;
}

} // namespace

SpatialTangent spatial_tangent(Eigen::Vector3d const& trial, Eigen::Matrix3d const& axes,
                               PowderResponse const& response, double volume_ratio) {
  SpatialTangent principal = SpatialTangent::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      principal(4 * i, 4 * j) = response.tangent(i, j) + response.stress[i];
      if (i == j)
        continue;
      double const quotient = divided_difference(trial, response, i, j);
      principal(3 * i + j, 3 * i + j) = quotient * trial[j];
      principal(3 * i + j, 3 * j + i) = quotient * trial[i];
    }
  SpatialTangent const turn = turning(axes);
  return volume_ratio * turn * principal * turn.transpose();
}

} // namespace continuum
