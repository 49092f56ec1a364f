#pragma once

#include <Eigen/Core>

#include <functional>

namespace coupling::study {

/// Residuals r(x) and their slopes d r / d x.
struct Residuals {
  Eigen::VectorXd values; ///< [n]
  Eigen::MatrixXd slopes; ///< n x n_unknowns
};

using ResidualsAt = std::function<Residuals(Eigen::VectorXd const&)>;

struct Box {
  Eigen::VectorXd low, high; ///< low <= high
};

struct BoxMinimum {
  Eigen::VectorXd x;
  double value; ///< sum of r^2
};

/// Least sum of r(x)^2 inside a box, from one start, by Levenberg's and Marquardt's method on the
/// unknowns that no bound holds back; where r hangs on fewer directions than there are unknowns,
/// the point near the start. Deterministic. Source: Nocedal, Wright, Numerical Optimization, 2nd
/// ed. (2006), sections 10.3 and 16.7.
/// @throws dem::PhysicsGuard if it has not come to rest after 2000 steps
BoxMinimum minimise_from(ResidualsAt const& residuals, Box const& box,
                         Eigen::VectorXd const& start);

/// The best from 3^k starts (corners, middles of edges and faces, centre) for up to four unknowns
/// that may move, from 100 of a Latin hypercube for more; the first of equals.
BoxMinimum minimise_in(ResidualsAt const& residuals, Box const& box);

} // namespace coupling::study
