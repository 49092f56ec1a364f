#include "coupling/study/surface_extremes.hpp"

#include "dem/expect.hpp"

#include <Eigen/QR>
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace coupling::study {
namespace {

using Eigen::VectorXd;

/// d^2 y / dx_f dx_g: constant for a quadratic.
Eigen::MatrixXd curvature_of(ResponseSurface const& surface) {
  int const k = surface.n_factors();
  VectorXd const zero = VectorXd::Zero(k), slope = surface.gradient(zero);
  Eigen::MatrixXd curvature(k, k);
  for (int f = 0; f < k; ++f)
    curvature.col(f) = surface.gradient(VectorXd::Unit(k, f)) - slope;
  return curvature;
}

/// Moves the free factors of x to where the gradient along them vanishes. Nothing if there is no
/// such point or a whole line of them: then a smaller face holds the extreme.
std::optional<VectorXd> stationary(ResponseSurface const& surface, Eigen::MatrixXd const& curvature,
                                   VectorXd x, std::vector<int> const& free) {
  if (free.empty())
    return x;
  for (int const f : free)
    x[f] = 0.0;
  VectorXd const slope = surface.gradient(x)(free);
  Eigen::MatrixXd const block = curvature(free, free);
  auto const qr = block.fullPivHouseholderQr();
  if (!qr.isInvertible())
    return std::nullopt;
  x(free) = qr.solve(-slope);
  return x;
}

} // namespace

SurfaceExtremes extremes_of(ResponseSurface const& surface, VectorXd const& low,
                            VectorXd const& high) {
  int const k = surface.n_factors();
  VALIDATE(k <= 10,
           fmt::format("extremes of {}: has {} factors (3^k faces are searched; at most 10). "
                       "Hold some?",
                       surface.data.response_name, k));
  auto const curvature = curvature_of(surface);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  SurfaceExtremes found{infinity, -infinity, {}, {}};
  auto const n_faces = std::lround(std::pow(3.0, k));
  for (long face = 0; face < n_faces; ++face) {
    VectorXd x(k);
    std::vector<int> free;
    long rest = face;
    for (int f = 0; f < k; ++f, rest /= 3) {
      x[f] = rest % 3 == 0 ? low[f] : high[f];
      if (rest % 3 == 2)
        free.push_back(f);
    }
    auto const point = stationary(surface, curvature, x, free);
    if (!point || (point->array() < low.array()).any() || (point->array() > high.array()).any())
      continue;
    double const y = surface.value(*point);
    if (y < found.lowest) {
      found.lowest = y;
      found.lowest_at = *point;
    }
    if (y > found.highest) {
      found.highest = y;
      found.highest_at = *point;
    }
  }
  return found;
}

} // namespace coupling::study
