#include "dem/surface/fit_shape.hpp"

#include "dem/surface/surface_edges.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dem {

namespace {

/// What both fits need to know about a patch.
struct Cloud {
  std::vector<Vec3> corners;                         // each vertex once
  Vec3 centroid = Vec3::Zero();                      // area-weighted
  Vec3 area = Vec3::Zero();                          // sum of area vectors
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero(); // sum of area-weighted n n^T
  double extent = 0.0;                               // diagonal of the box
};

Cloud gather(TriangleSurface const& surface, std::span<std::uint32_t const> triangles) {
  Cloud cloud;
  std::vector<std::uint32_t> rows;
  double total = 0.0;
  for (auto const t : triangles) {
    auto const& [a, b, c] = surface.triangles[t];
    Vec3 const area = area_vector(surface, t);
    double const weight = area.norm();
    cloud.area += area;
    cloud.normals += area * area.transpose() / weight;
    cloud.centroid +=
        weight / 3.0 * (surface.vertices[a] + surface.vertices[b] + surface.vertices[c]);
    total += weight;
    rows.insert(rows.end(), {a, b, c});
  }
  cloud.centroid /= total;
  std::ranges::sort(rows);
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  Vec3 low = surface.vertices[rows.front()], high = low;
  for (auto const row : rows) {
    cloud.corners.push_back(surface.vertices[row]);
    low = low.cwiseMin(cloud.corners.back());
    high = high.cwiseMax(cloud.corners.back());
  }
  cloud.extent = (high - low).norm();
  return cloud;
}

struct Frame {
  Vec3 e1, e2;
  explicit Frame(Vec3 const& axis) : e1(axis.unitOrthogonal()), e2(axis.cross(e1)) {}
};

struct Cylinder {
  Vec3 origin, axis;
  double radius;

  Vec3 radial(Vec3 const& point) const {
    Vec3 const arm = point - origin;
    return arm - arm.dot(axis) * axis;
  }
};

/// Circle through the corners seen along `axis`:  x^2 + y^2 = 2 a x + 2 b y + c  in the
/// least-squares sense (Kasa).
Cylinder first_guess(Cloud const& cloud, Vec3 const& axis) {
  Frame const frame(axis);
  Eigen::Matrix3d lhs = Eigen::Matrix3d::Zero();
  Vec3 rhs = Vec3::Zero();
  for (auto const& corner : cloud.corners) {
    Vec3 const arm = (corner - cloud.centroid) / cloud.extent; // of order 1, for the solver's sake
    Vec3 const row(2.0 * arm.dot(frame.e1), 2.0 * arm.dot(frame.e2), 1.0);
    double const x = arm.dot(frame.e1), y = arm.dot(frame.e2);
    lhs += row * row.transpose();
    rhs += (x * x + y * y) * row;
  }
  Vec3 const abc = lhs.ldlt().solve(rhs);
  double const radius2 = abc.z() + abc.x() * abc.x() + abc.y() * abc.y();
  return {cloud.centroid + cloud.extent * (abc.x() * frame.e1 + abc.y() * frame.e2), axis,
          cloud.extent * std::sqrt(std::max(radius2, 0.0))};
}

/// One Gauss-Newton step on the distances r_i = |radial_i| - R over (origin, axis, R), lengths in
/// extents.
Cylinder improve(Cloud const& cloud, Cylinder const& old) {
  using Vec5 = Eigen::Matrix<double, 5, 1>;
  Frame const frame(old.axis);
  Eigen::Matrix<double, 5, 5> lhs = Eigen::Matrix<double, 5, 5>::Zero();
  Vec5 rhs = Vec5::Zero();
  for (auto const& corner : cloud.corners) {
    Vec3 const radial = old.radial(corner);
    double const distance = radial.norm();
    if (distance == 0.0)
      continue;
    double const u = radial.dot(frame.e1) / distance, v = radial.dot(frame.e2) / distance;
    double const height = (corner - old.origin).dot(old.axis) / cloud.extent;
    Vec5 const row{-u, -v, -height * u, -height * v, -1.0};
    lhs += row * row.transpose();
    rhs -= (distance - old.radius) / cloud.extent * row;
  }
  Vec5 const step = lhs.ldlt().solve(rhs);
  return {old.origin + cloud.extent * (step[0] * frame.e1 + step[1] * frame.e2),
          (old.axis + step[2] * frame.e1 + step[3] * frame.e2).normalized(),
          old.radius + cloud.extent * step[4]};
}

double worst_corner(Cloud const& cloud, Cylinder const& cylinder) {
  double worst = 0.0;
  for (auto const& corner : cloud.corners)
    worst = std::max(worst, std::abs(cylinder.radial(corner).norm() - cylinder.radius));
  return worst;
}

/// Number of distinct angles about the axis at which corners stand.
std::size_t n_generators(Cloud const& cloud, Cylinder const& cylinder) {
  Frame const frame(cylinder.axis);
  std::vector<double> angles;
  for (auto const& corner : cloud.corners) {
    Vec3 const radial = cylinder.radial(corner);
    angles.push_back(std::atan2(radial.dot(frame.e2), radial.dot(frame.e1)));
  }
  std::ranges::sort(angles);
  auto const same = [](double a, double b) { return b - a < 1e-4; };
  angles.erase(std::unique(angles.begin(), angles.end(), same), angles.end());
  return angles.size();
}

bool turns_gently(TriangleSurface const& surface, std::span<std::uint32_t const> triangles,
                  Cylinder const& cylinder, double largest_turn) {
  double const least = std::cos(largest_turn);
  return std::ranges::all_of(triangles, [&](std::uint32_t t) {
    auto const& corners = surface.triangles[t];
    for (int k = 0; k < 3; ++k) {
      Vec3 const one = cylinder.radial(surface.vertices[corners[k]]).normalized();
      Vec3 const two = cylinder.radial(surface.vertices[corners[(k + 1) % 3]]).normalized();
      if (!(one.dot(two) >= least))
        return false;
    }
    return true;
  });
}

double outwards_or_inwards(TriangleSurface const& surface, std::span<std::uint32_t const> triangles,
                           Cylinder const& cylinder) {
  double sum = 0.0;
  for (auto const t : triangles)
    sum += area_vector(surface, t).dot(cylinder.radial(surface.vertices[surface.triangles[t][0]]));
  return sum > 0.0 ? 1.0 : -1.0;
}

} // namespace

std::optional<SmoothPatch> fit_plane(TriangleSurface const& surface,
                                     std::span<std::uint32_t const> triangles) {
  auto const cloud = gather(surface, triangles);
  Vec3 const normal = cloud.area.normalized();
  bool const flat = std::ranges::all_of(cloud.corners, [&](Vec3 const& corner) {
    return std::abs((corner - cloud.centroid).dot(normal)) <= recognition_tolerance * cloud.extent;
  });
  if (!flat)
    return std::nullopt;
  return SmoothPatch{.kind = PatchKind::plane, .origin = cloud.centroid, .direction = normal};
}

std::optional<SmoothPatch> fit_cylinder(TriangleSurface const& surface,
                                        std::span<std::uint32_t const> triangles,
                                        double largest_turn) {
  auto const cloud = gather(surface, triangles);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> const directions(cloud.normals);
  Cylinder cylinder = first_guess(cloud, directions.eigenvectors().col(0));
  for (int iteration = 0; iteration < 10; ++iteration)
    cylinder = improve(cloud, cylinder);
  if (!(worst_corner(cloud, cylinder) <= recognition_tolerance * cloud.extent))
    return std::nullopt;
  if (n_generators(cloud, cylinder) < 5)
    return std::nullopt;
  if (!turns_gently(surface, triangles, cylinder, largest_turn))
    return std::nullopt;
  Eigen::Index largest = 0;
  cylinder.axis.cwiseAbs().maxCoeff(&largest);
  if (cylinder.axis[largest] < 0.0)
    cylinder.axis = -cylinder.axis;
  Vec3 const middle =
      cylinder.origin + (cloud.centroid - cylinder.origin).dot(cylinder.axis) * cylinder.axis;
  return SmoothPatch{.kind = PatchKind::cylinder,
                     .origin = middle,
                     .direction = cylinder.axis,
                     .radius = cylinder.radius,
                     .side = outwards_or_inwards(surface, triangles, cylinder)};
}

} // namespace dem
