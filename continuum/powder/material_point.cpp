#include "continuum/powder/material_point.hpp"

#include "continuum/errors.hpp"
#include "continuum/powder/spatial_tangent.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace continuum {
namespace {

Eigen::Matrix3d in_axes(Eigen::Matrix3d const& axes, Eigen::Vector3d const& principal) {
  return axes * principal.asDiagonal() * axes.transpose();
}

} // namespace

double PowderPoint::volume_ratio() const {
  return deformation.determinant();
}

OrFailure<PointStep> advance(PowderLaw const& law, PowderPoint const& from,
                             Eigen::Matrix3d const& deformation) {
  Eigen::Matrix3d const increment = deformation * from.deformation.inverse();
  Eigen::Matrix3d const trial = increment * from.elastic_left_stretch * increment.transpose();
  // The iterative solver: the closed form loses digits where principal values agree.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> const spectrum((trial + trial.transpose()) / 2.0);
  Eigen::Vector3d const b = spectrum.eigenvalues();
  Eigen::Matrix3d const& axes = spectrum.eigenvectors();
  double const volume_ratio = deformation.determinant();
  // A step that turns the body inside out has no logarithm, and none that can be cut to one.
  if (!(volume_ratio > 0.0) || !(b.minCoeff() > 0.0))
    return PowderFailure{.reason = PowderFailure::Reason::inverted,
                         .n_iterations = 0,
                         .least_residual = 0.0,
                         .relative_density = relative_density(law, from.powder)};

  auto const answer = respond(law, from.powder, 0.5 * b.array().log());
  if (!answer)
    return answer.failure();
  PowderResponse const& end = *answer;
  Eigen::Matrix3d const cauchy = in_axes(axes, end.stress);
  return PointStep{
      .point = {.deformation = deformation,
                .elastic_left_stretch = in_axes(axes, (2.0 * end.elastic_strain).array().exp()),
                .powder = end.state,
                .plastic_work = from.plastic_work + volume_ratio * end.plastic_work},
      .cauchy = cauchy,
      .kirchhoff = volume_ratio * cauchy,
      .tangent = spatial_tangent(b, axes, end, volume_ratio),
      .surface = end.surface};
}

Eigen::Matrix3d cauchy_stress(PowderLaw const& law, PowderPoint const& point) {
  auto const step = advance(law, point, point.deformation);
  if (!step)
    throw SolverFailure(step.failure().message());
  return step->cauchy;
}

} // namespace continuum
