#pragma once

#include "continuum/powder/material_point.hpp"

namespace continuum {

/// The tangent in fixed axes out of that in principal axes. In the axes of b (trial), with
/// eps_a = 1/2 ln b_a and delta b = L b + b L^T:
///     d tau_aa = J [D_ac + sigma_a] L_cc,
///     d tau_ab = J (sigma_a - sigma_b)/(b_a - b_b) [b_b L_ab + b_a L_ba],   a != b;
/// for b_a = b_b the quotient is its limit (D_aa - D_ab)/(2 b_a).
/// @param trial         b_a, principal values of the trial b_e [-]
/// @param axes          its principal axes as columns
/// @param response      stress [Pa] and its derivative by the trial strains [Pa]
/// @param volume_ratio  J [-]
/// Source: Ogden (1997), 6.1.4; de Souza Neto et al. (2008), A.5.
SpatialTangent spatial_tangent(Eigen::Vector3d const& trial, Eigen::Matrix3d const& axes,
                               PowderResponse const& response, double volume_ratio);

} // namespace continuum
