#include "dem/surface/closest_point.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace dem {

namespace {

Vec3 on_side(int side, double s) {
  Vec3 weights = Vec3::Zero();
  weights[side] = 1.0 - s;
  weights[(side + 1) % 3] = s;
  return weights;
}

ClosestPoint side_or_corner(int side, double s, Vec3 const& point, Vec3 const& centre) {
  bool const is_corner = s <= 0.0 || s >= 1.0;
  int const row = is_corner && s >= 1.0 ? (side + 1) % 3 : side;
  return {.point = point,
          .weights = on_side(side, s),
          .distance = (point - centre).norm(),
          .feature = is_corner ? Feature::corner : Feature::side,
          .row = static_cast<std::uint8_t>(row)};
}

ClosestPoint closest_on_sides(CurvedTriangle const& triangle, Vec3 const& centre) {
  std::optional<ClosestPoint> best;
  for (int k = 0; k < 3; ++k) {
    auto const& a = triangle.corners[k];
    auto const& b = triangle.corners[(k + 1) % 3];
    double const s = closest_on_arc(a, b, triangle.bulges[k], centre);
    Vec3 const point = s >= 1.0 ? b : a + s * (b - a) + 4.0 * s * (1.0 - s) * triangle.bulges[k];
    auto const found = side_or_corner(k, s, point, centre);
    if (!best || is_nearer(found, *best))
      best = found;
  }
  return *best;
}

/// Newton's step for 1/2 |x(b) - centre|^2 in (b_1, b_2). Beyond the centre of curvature the true
/// Hessian is not positive; Gauss and Newton's is, and still goes downhill.
Eigen::Vector2d newton_step(CurvedTriangle const& triangle, Vec3 const& weights,
                            Vec3 const& centre) {
  auto const [xu, xv] = triangle.tangents(weights);
  Vec3 const gap = triangle.at(weights) - centre;
  auto const& [b0, b1, b2] = triangle.bulges;
  double const guu = xu.dot(xu), gvv = xv.dot(xv), guv = xu.dot(xv);
  double huu = guu - 8.0 * b0.dot(gap);
  double hvv = gvv - 8.0 * b2.dot(gap);
  double huv = guv + 4.0 * (b1 - b0 - b2).dot(gap);
  if (huu <= 0.0 || huu * hvv - huv * huv <= 1e-3 * (guu * gvv - guv * guv))
    huu = guu, hvv = gvv, huv = guv;
  double const ru = -xu.dot(gap), rv = -xv.dot(gap);
  double const determinant = huu * hvv - huv * huv;
  return {(hvv * ru - huv * rv) / determinant, (huu * rv - huv * ru) / determinant};
}

std::optional<ClosestPoint> closest_inside(CurvedTriangle const& triangle, Vec3 const& centre,
                                           Vec3 weights) {
  constexpr double converged = 1e-9; // the step after it would be its square
  constexpr double stalled =
      1e-7; // a needle's rounding noise; the point itself is as good as its coordinates
  double size = 1.0;
  for (int iteration = 0; iteration < 12 && size > converged; ++iteration) {
    Eigen::Vector2d const step = newton_step(triangle, weights, centre);
    weights += Vec3(-step.sum(), step.x(), step.y());
    size = step.cwiseAbs().maxCoeff();
    if (!(weights.minCoeff() > -1.0))
      return std::nullopt; // far outside, or not a number
  }
  if (size > stalled || weights.minCoeff() < 0.0)
    return std::nullopt;
  Vec3 const point = triangle.at(weights);
  return ClosestPoint{point, weights, (point - centre).norm(), Feature::face, 0};
}

} // namespace

Vec3 CurvedTriangle::at(Vec3 const& w) const {
  return w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2] +
         4.0 * (w[0] * w[1] * bulges[0] + w[1] * w[2] * bulges[1] + w[2] * w[0] * bulges[2]);
}

std::array<Vec3, 2> CurvedTriangle::tangents(Vec3 const& w) const {
  return {
      corners[1] - corners[0] + 4.0 * ((w[0] - w[1]) * bulges[0] + w[2] * (bulges[1] - bulges[2])),
      corners[2] - corners[0] + 4.0 * ((w[0] - w[2]) * bulges[2] + w[1] * (bulges[1] - bulges[0]))};
}

bool is_nearer(ClosestPoint const& one, ClosestPoint const& other) {
  if (one.feature < other.feature)
    return one.distance <= other.distance * (1.0 + equally_near);
  if (one.feature > other.feature)
    return one.distance < other.distance * (1.0 - equally_near);
  return one.distance < other.distance;
}

ClosestPoint closest_on_flat(std::array<Vec3, 3> const& corners, Vec3 const& centre) {
  Vec3 const ab = corners[1] - corners[0], ac = corners[2] - corners[0], ap = centre - corners[0];
  double const bb = ab.dot(ab), bc = ab.dot(ac), cc = ac.dot(ac), bp = ab.dot(ap), cp = ac.dot(ap);
  double const determinant = bb * cc - bc * bc;
  double const v = (cc * bp - bc * cp) / determinant, w = (bb * cp - bc * bp) / determinant;
  if (v >= 0.0 && w >= 0.0 && v + w <= 1.0) {
    Vec3 const point = corners[0] + v * ab + w * ac;
    return {point, Vec3(1.0 - v - w, v, w), (point - centre).norm(), Feature::face, 0};
  }
  return closest_on_sides({.corners = corners}, centre);
}

double closest_on_arc(Vec3 const& a, Vec3 const& b, Vec3 const& bulge, Vec3 const& centre) {
  Vec3 const chord = b - a;
  double const length2 = chord.squaredNorm();
  double s = std::clamp((centre - a).dot(chord) / length2, 0.0, 1.0);
  if (bulge.isZero(0.0))
    return s;
  for (int iteration = 0; iteration < 30; ++iteration) {
    Vec3 const gap = a + s * chord + 4.0 * s * (1.0 - s) * bulge - centre;
    Vec3 const tangent = chord + 4.0 * (1.0 - 2.0 * s) * bulge;
    double const curvature = tangent.squaredNorm() - 8.0 * bulge.dot(gap);
    double const slope = tangent.dot(gap);
    double const next =
        std::clamp(s - slope / (curvature > 0.1 * length2 ? curvature : length2), 0.0, 1.0);
    double const step = std::abs(next - s);
    s = next;
    if (step < 1e-9) // the step after it would be its square
      break;
  }
  return s;
}

ClosestPoint closest_on_curved(CurvedTriangle const& triangle, Vec3 const& centre) {
  auto const flat = closest_on_flat(triangle.corners, centre);
  if (triangle.is_flat)
    return flat;
  if (auto const inside = closest_inside(triangle, centre, flat.weights))
    return *inside;
  return closest_on_sides(triangle, centre);
}

} // namespace dem
