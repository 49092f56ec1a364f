#pragma once

#include "coupling/press.hpp"

#include <Eigen/Core>

namespace coupling {

/// Makes a fixed-point iteration x = H(x) converge: from the iterates so far to the next.
class FixedPointAccelerator {
public:
  /// @param first  relaxation of the first step, in (0, 1]
  FixedPointAccelerator(Accelerator kind, double first) : kind_(kind), relaxation_(first) {}

  /// @param x  the newest iterate
  /// @param h  H(x)
  /// aitken:  x + w (h - x),  w <- -w r_k.(r_k+1 - r_k) / |r_k+1 - r_k|^2, kept in [0.05, 1.5]
  /// iqn_ils: h + W c with V c = -(h - x) in least squares; V and W hold the differences of
  ///          residuals and of H between iterates, newest first, dependent columns left out
  ///          (Degroote et al., Comput. Struct. 87 (2009) 793)
  Eigen::VectorXd next(Eigen::VectorXd const& x, Eigen::VectorXd const& h);

private:
  Eigen::VectorXd relaxed(Eigen::VectorXd const& x, Eigen::VectorXd const& residual);
  Eigen::VectorXd quasi_newton(Eigen::VectorXd const& h, Eigen::VectorXd const& residual);

  Accelerator kind_;
  double relaxation_;
  std::vector<Eigen::VectorXd> residuals_, values_;
};

/// Chooses the course of the window that begins, so that the loads at its end hold it: the window
/// is tried on copies of the press; the press itself only learns the course. A tried window that is
/// run again gives the same bits.
/// @throws dem::PhysicsGuard  if the iteration does not converge
void find_course(Press& press);

} // namespace coupling
