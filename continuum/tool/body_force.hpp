#pragma once

#include "continuum/tool/tool_mesh.hpp"

#include <Eigen/Core>

#include <functional>

namespace continuum {

/// Force per volume [N/m^3] at a position [m].
using BodyForce = std::function<Eigen::Vector3d(Eigen::Vector3d const& position)>;

/// Consistent nodal forces of a body force:  f_a = integral N_a b dV   [N], 3 x n_nodes of the
/// mesh, by 4 x 4 x 4 Gauss points a cell: exact for cubic b on cells that are parallelepipeds.
Eigen::Matrix3Xd body_force_loads(ToolMesh const& mesh, BodyForce const& force);

} // namespace continuum
