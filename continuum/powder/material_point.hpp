#pragma once

#include "continuum/powder/powder_law.hpp"

#include <Eigen/Core>

namespace continuum {

/// A point of powder at finite strain, between two steps. F = Fe Fp; what is kept of Fe is
/// b_e = Fe Fe^T, whose principal values are exp(2 eps^e). Objective by construction.
struct PowderPoint {
  Eigen::Matrix3d deformation = Eigen::Matrix3d::Identity();          ///< F from the start [-]
  Eigen::Matrix3d elastic_left_stretch = Eigen::Matrix3d::Identity(); ///< b_e [-]
  PowderState powder;
  double plastic_work = 0.0; ///< [J/m^3 of the start's volume]

  double volume_ratio() const; ///< J = det F; the density under load is D_0 / J
};

/// d tau_ij / d L_kl at [3 i + j, 3 k + l] [Pa], for variations delta F = L F of the step's end:
/// tau is the Kirchhoff stress, L a displacement's gradient by PRESENT position, not symmetrised.
/// So delta P = (delta tau - tau L^T) F^-T for P = tau F^-T, and for a test function w
///     delta (grad w : tau) = grad w : A : grad u - tau_ij w_i,k u_k,j.
using SpatialTangent = Eigen::Matrix<double, 9, 9>;

/// End of one step in fixed axes; tension positive.
struct PointStep {
  PowderPoint point;
  Eigen::Matrix3d cauchy;    ///< sigma [Pa]
  Eigen::Matrix3d kirchhoff; ///< tau = J sigma [Pa]
  SpatialTangent tangent;    ///< consistent with the discrete step, unsymmetric in general
  PowderSurface surface;
};

/// One implicit step from a point to the deformation F: trial b_e = dF b_e dF^T with
/// dF = F F_old^-1, law in its principal axes, b_e anew from the elastic strains that come back.
/// @return  the step's end, or why there is none; the point itself is never changed
/// Source: Simo (1992); Perez-Foguet, Rodriguez-Ferran and Huerta (2001) for Cauchy stress in the
/// law with J fixed by the trial; de Souza Neto et al. (2008), box 14.3.
OrFailure<PointStep> advance(PowderLaw const& law, PowderPoint const& from,
                             Eigen::Matrix3d const& deformation);

/// Cauchy stress of a point as it stands [Pa]: that of its elastic strain at its density.
/// @throws SolverFailure if the point is outside its surface, which no step leaves behind
Eigen::Matrix3d cauchy_stress(PowderLaw const& law, PowderPoint const& point);

} // namespace continuum
