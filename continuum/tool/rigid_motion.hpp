#pragma once

#include <Eigen/Core>

#include <vector>

namespace continuum {

/// @param nodes  positions [m], 3 x n_nodes
/// @param held   of component 3 a + c
/// @throws InvalidInput naming a rigid motion that the held components leave free
void refuse_mechanism(Eigen::Matrix3Xd const& nodes, std::vector<bool> const& held);

} // namespace continuum
