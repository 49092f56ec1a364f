#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace continuum {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

/// A symmetric positive definite matrix, factorised once by MUMPS (Cholesky, through PETSc)
/// on all ranks. For the first rank, which alone has the matrix.
class CholeskyFactor {
public:
  /// @throws SolverFailure if the matrix is not positive definite, or memory runs out
  explicit CholeskyFactor(SparseMatrix const& matrix);
  ~CholeskyFactor();
  CholeskyFactor(CholeskyFactor&&) noexcept;
  CholeskyFactor& operator=(CholeskyFactor&&) noexcept;

  Eigen::VectorXd solve(Eigen::VectorXd const& right_side) const;

private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

/// S = A_kk - A_kr A_rr^-1 A_rk, k the rows to keep (ascending), r the rest; dense and symmetric.
/// @throws SolverFailure as CholeskyFactor
Eigen::MatrixXd schur_complement(SparseMatrix const& matrix, std::vector<int> const& keep);

} // namespace continuum
