#include "continuum/tool/factor.hpp"

#include "continuum/errors.hpp"

#include <petscmat.h>

#include <string>
#include <utility>

namespace continuum {

namespace {
// Every code is looked at: PETSc's own calls go on with a zero solution after an error.
void check(PetscErrorCode code, char const* doing) {
  if (code == 0)
    return;
  char const* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw SolverFailure(std::string("linear solver: ") + doing + " failed (" +
                      (text ? text : "unknown error") + "). Is there enough memory for this mesh?");
}

// The matrix shares its arrays with Eigen's, which outlives it; only MUMPS keeps its own copy.
class PetscView {
public:
  explicit PetscView(SparseMatrix const& matrix) {
    // PETSc asks for writable arrays; the factorisation leaves them alone.
    check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, matrix.rows(), matrix.cols(),
                                    const_cast<int*>(matrix.outerIndexPtr()),
                                    const_cast<int*>(matrix.innerIndexPtr()),
                                    const_cast<double*>(matrix.valuePtr()), &mat),
          "handing over the matrix");
    // Without these MUMPS takes LU at twice the memory.
    check(MatSetOption(mat, MAT_SYMMETRIC, PETSC_TRUE), "marking the matrix");
    check(MatSetOption(mat, MAT_SPD, PETSC_TRUE), "marking the matrix");
  }
  ~PetscView() { MatDestroy(&mat); }
  PetscView(PetscView const&) = delete;
  PetscView& operator=(PetscView const&) = delete;

  Mat mat = nullptr;
};

void factorise(Mat factor, Mat matrix) {
  MatFactorInfo info;
  check(MatFactorInfoInitialize(&info), "starting");
  check(MatCholeskyFactorSymbolic(factor, matrix, nullptr, &info), "the analysis");
  check(MatCholeskyFactorNumeric(factor, matrix, &info), "the factorisation");
  MatFactorError error = MAT_FACTOR_NOERROR;
  check(MatFactorGetError(factor, &error), "the factorisation");
  if (error == MAT_FACTOR_OUTMEMORY)
    throw SolverFailure("linear solver: not enough memory. Use larger cells?");
  if (error != MAT_FACTOR_NOERROR)
    throw SolverFailure("linear solver: the stiffness matrix is not positive definite (MUMPS found "
                        "a pivot that is not). Is the tool supported, and no cell inverted?");
}
} // namespace

struct CholeskyFactor::Factor {
  Mat mat = nullptr;
  Factor() = default;
  ~Factor() { MatDestroy(&mat); }
  Factor(Factor const&) = delete;
  Factor& operator=(Factor const&) = delete;
};

CholeskyFactor::CholeskyFactor(SparseMatrix const& matrix) : factor_(std::make_unique<Factor>()) {
  PetscView const view(matrix);
  check(MatGetFactor(view.mat, MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, &factor_->mat),
        "finding MUMPS");
  factorise(factor_->mat, view.mat);
}

CholeskyFactor::~CholeskyFactor() = default;
CholeskyFactor::CholeskyFactor(CholeskyFactor&&) noexcept = default;
CholeskyFactor& CholeskyFactor::operator=(CholeskyFactor&&) noexcept = default;

Eigen::VectorXd CholeskyFactor::solve(Eigen::VectorXd const& right_side) const {
  Eigen::VectorXd solution(right_side.size());
  struct Pair {
    Vec b = nullptr, x = nullptr;
    ~Pair() { VecDestroy(&b), VecDestroy(&x); }
  } vectors;
  PetscInt const n = right_side.size();
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, right_side.data(), &vectors.b), "a vector");
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, solution.data(), &vectors.x), "a vector");
  check(MatSolve(factor_->mat, vectors.b, vectors.x), "the back-substitution");
  return solution;
}

Eigen::MatrixXd schur_complement(SparseMatrix const& matrix, std::vector<int> const& keep) {
  struct Handles {
    Mat factor = nullptr, schur = nullptr;
    IS kept = nullptr;
    ~Handles() { MatDestroy(&schur), MatDestroy(&factor), ISDestroy(&kept); }
  } own;
  PetscView const view(matrix);
  check(MatGetFactor(view.mat, MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, &own.factor), "finding MUMPS");
  check(ISCreateGeneral(PETSC_COMM_SELF, keep.size(), keep.data(), PETSC_COPY_VALUES, &own.kept),
        "the interface");
  check(MatFactorSetSchurIS(own.factor, own.kept), "the interface");
  factorise(own.factor, view.mat);
  check(MatFactorCreateSchurComplement(own.factor, &own.schur, nullptr), "the condensation");
  PetscInt stride = 0;
  PetscScalar const* values = nullptr;
  check(MatDenseGetLDA(own.schur, &stride), "the condensation");
  check(MatDenseGetArrayRead(own.schur, &values), "the condensation");
  auto const n = static_cast<Eigen::Index>(keep.size());
  Eigen::MatrixXd const dense = Eigen::Map<Eigen::MatrixXd const, 0, Eigen::OuterStride<>>(
      values, n, n, Eigen::OuterStride<>(stride));
  check(MatDenseRestoreArrayRead(own.schur, &values), "the condensation");
  // MUMPS may fill one triangle only; its own rounding would make the other differ in the last
  // digit.
  bool const is_lower = n < 2 || dense(n - 1, 0) != 0.0 || dense(0, n - 1) == 0.0;
  return is_lower ? Eigen::MatrixXd(dense.selfadjointView<Eigen::Lower>())
                  : Eigen::MatrixXd(dense.selfadjointView<Eigen::Upper>());
}

} // namespace continuum
