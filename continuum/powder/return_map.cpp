#include "continuum/powder/return_map.hpp"

namespace continuum::return_map {

Split split(Eigen::Vector3d const& trial_strain, double compaction) {
  Eigen::Vector3d const deviator = trial_strain.array() - trial_strain.mean();
  double const size = deviator.norm();
  return {.trial = {.volumetric = -trial_strain.sum(),
                    .deviatoric = std::sqrt(2.0 / 3.0) * size,
                    .compaction = compaction},
          .direction = size > 0.0 ? Eigen::Vector3d(deviator / size) : Eigen::Vector3d::Zero()};
}

PowderResponse respond(Split const& split, End const& end) {
  Eigen::Vector3d const one = Eigen::Vector3d::Ones();
  Eigen::Vector3d const& n = split.direction;
  double const root = std::sqrt(2.0 / 3.0);
  Trial const& trial = split.trial;
  // Across the deviator's direction stress turns with the trial strain: secant 2/3 q/eps_q. Without
  // a deviator there is no direction, and the secant is the tangent.
  bool const has_direction = trial.deviatoric > 1e-14;
  double const across = 2.0 / 3.0 * (has_direction ? end.q / trial.deviatoric : end.tangent(1, 1));
  Eigen::Matrix3d const deviators =
      Eigen::Matrix3d::Identity() - Eigen::Matrix3d::Constant(1.0 / 3.0);
  Eigen::Vector3d const along = has_direction ? n : Eigen::Vector3d::Zero();

  Eigen::Vector3d const by_p = -end.tangent(0, 0) * one + root * end.tangent(0, 1) * along;
  Eigen::Vector3d const by_q = -end.tangent(1, 0) * one + root * end.tangent(1, 1) * along;
  PlasticStep const flow{.volumetric = trial.volumetric - end.elastic_volume,
                         .deviatoric = trial.deviatoric - end.elastic_shear};
  return {.elastic_strain =
              -end.elastic_volume / 3.0 * one + std::sqrt(1.5) * end.elastic_shear * n,
          .stress = -end.p * one + root * end.q * n,
          .tangent = -one * by_p.transpose() + root * along * by_q.transpose() +
                     across * (deviators - along * along.transpose()),
          .state = {.plastic_compaction = trial.compaction + flow.volumetric},
          .surface = end.surface,
          .plastic_work = end.p * flow.volumetric + end.q * flow.deviatoric};
}

} // namespace continuum::return_map
