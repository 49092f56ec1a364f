#include "coupling/elastic/elastic_surface.hpp"

#include <Eigen/Geometry>

#include <algorithm>

namespace coupling {
namespace {

// Lebesgue constant of the biquadratic face: between its nodes nothing exceeds their largest value
// by more.
constexpr double between_nodes = 1.25 * 1.25;

double largest(Eigen::Matrix3Xd const& vectors) {
  return between_nodes * std::sqrt(vectors.colwise().squaredNorm().maxCoeff());
}

dem::Vec3 interpolate(continuum::TraceFace const& face, Eigen::Matrix<double, 9, 1> const& shape,
                      Eigen::Matrix3Xd const& nodal) {
  dem::Vec3 value = dem::Vec3::Zero();
  for (int a = 0; a < 9; ++a)
    value += shape[a] * nodal.col(face.nodes[static_cast<std::size_t>(a)]);
  return value;
}

double share(double error, double scale) {
  return scale > 0.0 ? error / scale : error;
}

} // namespace

ElasticSurface::ElasticSurface(continuum::SurfaceTrace trace, dem::Vec3 const& offset,
                               std::vector<std::uint32_t> patches)
    : trace_(std::move(trace)), locator_(trace_), offset_(offset), patches_(std::move(patches)),
      displacement_(Eigen::Matrix3Xd::Zero(3, trace_.positions.cols())), velocity_(displacement_) {
  std::ranges::sort(patches_);
}

void ElasticSurface::set_course(Eigen::Matrix3Xd const& displacement,
                                Eigen::Matrix3Xd const& velocity, double length) {
  displacement_ = displacement;
  velocity_ = velocity;
  speed_ = largest(velocity);
  extent_ = largest(displacement) + length * speed_;
}

Eigen::Matrix3Xd ElasticSurface::nodal(std::span<dem::WallImpulse const> impulses,
                                       std::size_t tool) const {
  Eigen::Matrix3Xd nodal = Eigen::Matrix3Xd::Zero(3, trace_.positions.cols());
  for (dem::WallImpulse const& hit : impulses) {
    if (hit.tool != tool)
      continue;
    auto const shape = continuum::face_shape(hit.place.xi, hit.place.eta);
    auto const& nodes = trace_.faces[hit.place.face].nodes;
    for (int a = 0; a < 9; ++a)
      nodal.col(nodes[static_cast<std::size_t>(a)]) += shape[a] * hit.impulse;
  }
  return nodal;
}

TransferErrors ElasticSurface::errors(std::span<dem::WallImpulse const> impulses, std::size_t tool,
                                      Eigen::Matrix3Xd const& nodal) const {
  dem::Vec3 force = -nodal.rowwise().sum(), moment = dem::Vec3::Zero();
  double power = -(nodal.array() * velocity_.array()).sum();
  for (Eigen::Index a = 0; a < nodal.cols(); ++a)
    moment -= dem::Vec3(trace_.positions.col(a)).cross(dem::Vec3(nodal.col(a)));
  double forces = 0.0, moments = 0.0, powers = 0.0;
  for (dem::WallImpulse const& hit : impulses) {
    if (hit.tool != tool)
      continue;
    dem::Vec3 const x = trace_.position(hit.place.face, hit.place.xi, hit.place.eta);
    dem::Vec3 const v = at(hit.place).velocity;
    force += hit.impulse;
    moment += x.cross(hit.impulse);
    power += v.dot(hit.impulse);
    forces += hit.impulse.norm();
    moments += x.norm() * hit.impulse.norm();
    powers += v.norm() * hit.impulse.norm();
  }
  return {.force = share(force.norm(), forces),
          .moment = share(moment.norm(), moments),
          .power = share(std::abs(power), powers)};
}

dem::SurfacePlace ElasticSurface::locate(std::uint32_t patch, dem::Vec3 const& point) const {
  if (!std::ranges::binary_search(patches_, patch))
    return {};
  return locator_.nearest(point - offset_).place;
}

dem::ToolDeformation::Motion ElasticSurface::at(dem::SurfacePlace const& place) const {
  if (place.face == dem::SurfacePlace::rigid)
    return {};
  auto const shape = continuum::face_shape(place.xi, place.eta);
  auto const& face = trace_.faces[place.face];
  return {.displacement = interpolate(face, shape, displacement_),
          .velocity = interpolate(face, shape, velocity_)};
}

} // namespace coupling
