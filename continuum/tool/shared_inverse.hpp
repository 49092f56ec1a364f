#pragma once

#include <Eigen/Core>

namespace continuum {

/// The inverse of a symmetric positive definite matrix. Alone by Eigen's Cholesky factor and n
/// right-hand sides; over ranks, where this takes most of a condensation, each rank factorises the
/// matrix and finds its share of the columns, from the diagonal down, in 1/3 n^3 + 2/3 n^3 / ranks
/// instead of 7/3 n^3 multiplications. For the first rank.
/// @throws SolverFailure if the matrix is not positive definite, or memory runs out
Eigen::MatrixXd shared_inverse(Eigen::MatrixXd matrix);

/// What the other ranks do meanwhile.
void help_inverting(int size);

} // namespace continuum
