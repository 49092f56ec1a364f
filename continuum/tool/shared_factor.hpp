#pragma once

#include "continuum/tool/factor.hpp"

#include <memory>
#include <vector>

namespace continuum {

/// One rank's part in a factorisation by MUMPS (Cholesky, through PETSc) on all ranks: every rank
/// makes the same calls in the same order, the destructor included. The rows stay on the first
/// rank, where K was assembled; the others give none. MUMPS itself spreads the fronts, which are
/// most of the memory and all of the time, over the ranks.
class SharedFactor {
public:
  /// @param rows  on the first rank the matrix, which must live as long as this call; elsewhere
  ///              `no_rows(size)`
  /// @throws SolverFailure if the matrix is not positive definite, or memory runs out
  explicit SharedFactor(SparseMatrix const& rows);
  ~SharedFactor();
  SharedFactor(SharedFactor const&) = delete;
  SharedFactor& operator=(SharedFactor const&) = delete;

  /// @param right_side  on the first rank; elsewhere empty
  /// @return            the solution on the first rank; elsewhere empty
  Eigen::VectorXd solve(Eigen::VectorXd const& right_side) const;

private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

/// See `schur_complement`. @return on the first rank; elsewhere empty
Eigen::MatrixXd shared_schur_complement(SparseMatrix const& rows, std::vector<int> const& keep);

/// What a rank but the first gives of a matrix.
inline SparseMatrix no_rows(int size) {
  return SparseMatrix(0, size);
}

} // namespace continuum
