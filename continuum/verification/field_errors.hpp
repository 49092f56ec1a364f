#pragma once

#include "continuum/tool/elastic_tool.hpp"

#include <Eigen/Core>

#include <functional>

namespace continuum::verification {

/// A known solution.
struct ExactField {
  std::function<Eigen::Vector3d(Eigen::Vector3d const&)> displacement; ///< [m] at a position [m]
  std::function<Eigen::Matrix3d(Eigen::Vector3d const&)> stress;       ///< [Pa]
};

/// Relative L2 errors.
struct FieldErrors {
  double displacement; ///< on the boundary, between the nodes, too: they alone converge too well
  double stress;       ///< in the body
};

FieldErrors errors_of(ElasticTool const& tool, Eigen::Matrix3Xd const& displacement,
                      ExactField const& exact);

} // namespace continuum::verification
