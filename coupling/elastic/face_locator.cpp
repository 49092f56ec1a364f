#include "coupling/elastic/face_locator.hpp"

#include "dem/expect.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace coupling {
namespace {

constexpr int most_iterations = 20;
constexpr double reached = 1e-13; // of the face, in xi and eta

Eigen::Matrix<double, 3, 9> corners_of(continuum::SurfaceTrace const& trace, std::uint32_t face) {
  Eigen::Matrix<double, 3, 9> x;
  for (int a = 0; a < 9; ++a)
    x.col(a) = trace.positions.col(trace.faces[face].nodes[static_cast<std::size_t>(a)]);
  return x;
}

/// One step towards the foot point; a coordinate that would leave the face stays on its rim, and
/// the other one goes on alone.
Eigen::Vector2d step_towards(Eigen::Matrix<double, 3, 2> const& tangents, dem::Vec3 const& miss,
                             Eigen::Vector2d const& at) {
  Eigen::Matrix2d const metric = tangents.transpose() * tangents;
  Eigen::Vector2d const slope = tangents.transpose() * miss;
  Eigen::Vector2d next = at + metric.inverse() * slope;
  for (int k : {0, 1}) {
    double const kept = std::clamp(next[k], 0.0, 1.0);
    if (kept == next[k])
      continue;
    int const other = 1 - k;
    next[k] = kept;
    next[other] = at[other] + (slope[other] - metric(0, 1) * (kept - at[k])) / metric(other, other);
  }
  return next.cwiseMax(0.0).cwiseMin(1.0);
}

} // namespace

FaceLocator::FaceLocator(continuum::SurfaceTrace const& trace) : trace_(&trace) {
  VALIDATE(!trace.faces.empty(),
           "deformable tools: a surface without faces cannot carry grains. Is the mesh empty?");
  for (std::uint32_t face = 0; face < trace.faces.size(); ++face) {
    auto const x = corners_of(trace, face);
    dem::Vec3 const centre = trace.position(face, 0.5, 0.5);
    // A second-order face bulges from its nodes by less than their spread.
    balls_.push_back({centre, 1.25 * (x.colwise() - centre).colwise().norm().maxCoeff()});
  }
}

FaceLocator::Nearest FaceLocator::nearest_on(std::uint32_t face, dem::Vec3 const& point) const {
  auto const x = corners_of(*trace_, face);
  Eigen::Vector2d at(0.5, 0.5);
  for (int k = 0; k < most_iterations; ++k) {
    dem::Vec3 const miss = point - x * continuum::face_shape(at.x(), at.y());
    Eigen::Matrix<double, 3, 2> const tangents = x * continuum::face_shape_gradient(at.x(), at.y());
    Eigen::Vector2d const next = step_towards(tangents, miss, at);
    double const moved = (next - at).cwiseAbs().maxCoeff();
    at = next;
    if (moved <= reached)
      break;
  }
  dem::Vec3 const foot = x * continuum::face_shape(at.x(), at.y());
  return {.place = {face, at.x(), at.y()}, .distance = (point - foot).norm()};
}

FaceLocator::Nearest FaceLocator::nearest(dem::Vec3 const& point) const {
  std::uint32_t first = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t face = 0; face < balls_.size(); ++face) {
    double const square = (balls_[face].centre - point).squaredNorm();
    if (square < least)
      least = square, first = face;
  }
  Nearest best = nearest_on(first, point);
  auto const& [_, xi, eta] = best.place;
  bool const is_inside = xi > 0.0 && xi < 1.0 && eta > 0.0 && eta < 1.0;
  if (is_inside)
    return best;
  for (std::uint32_t face = 0; face < balls_.size(); ++face) {
    double const away = (balls_[face].centre - point).norm() - balls_[face].radius;
    if (face == first || away >= best.distance)
      continue;
    Nearest const other = nearest_on(face, point);
    if (other.distance < best.distance)
      best = other;
  }
  return best;
}

} // namespace coupling
