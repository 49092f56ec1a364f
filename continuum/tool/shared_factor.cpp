#include "continuum/tool/shared_factor.hpp"

#include "continuum/errors.hpp"
#include "continuum/ranks.hpp"

#include <petscmat.h>

#include <array>
#include <string>

namespace continuum {

namespace {
// Every code is looked at: PETSc's own calls go on with a zero solution after an error.
void check(PetscErrorCode code, char const* doing) {
  if (code == 0)
    return;
  char const* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  std::string const failure = std::string("linear solver: ") + doing + " failed (" +
                              (text ? text : "unknown error") +
                              "). Is there enough memory for this mesh?";
  // The other ranks may wait for this one inside MUMPS, and so may the destructors on the way out.
  ranks::expect_agreement(failure);
  throw SolverFailure(failure);
}

MPI_Comm all_ranks() {
  return ranks::count() == 1 ? PETSC_COMM_SELF : PETSC_COMM_WORLD;
}

// The matrix shares its arrays with Eigen's, which outlives it; only MUMPS keeps its own copy.
class PetscView {
public:
  explicit PetscView(SparseMatrix const& rows) {
    // PETSc asks for writable arrays; the factorisation leaves them alone.
    auto* const begins = const_cast<int*>(rows.outerIndexPtr());
    auto* const columns = const_cast<int*>(rows.innerIndexPtr());
    auto* const values = const_cast<double*>(rows.valuePtr());
    if (ranks::count() == 1)
      check(MatCreateSeqAIJWithArrays(all_ranks(), rows.rows(), rows.cols(), begins, columns,
                                      values, &mat),
            "handing over the matrix");
    else
      share(rows, begins, columns, values);
    // Without these MUMPS takes LU at twice the memory.
    check(MatSetOption(mat, MAT_SYMMETRIC, PETSC_TRUE), "marking the matrix");
    check(MatSetOption(mat, MAT_SPD, PETSC_TRUE), "marking the matrix");
  }
  ~PetscView() { MatDestroy(&mat); }
  PetscView(PetscView const&) = delete;
  PetscView& operator=(PetscView const&) = delete;

  Mat mat = nullptr;

private:
  // Each rank owns the columns of its own rows, so the first has no others and the rest nothing.
  void share(SparseMatrix const& rows, int* begins, int* columns, double* values) {
    others_.assign(rows.rows() + 1, 0);
    check(MatCreateMPIAIJWithSplitArrays(all_ranks(), rows.rows(), rows.rows(), rows.cols(),
                                         rows.cols(), begins, columns, values, others_.data(),
                                         no_columns_.data(), no_values_.data(), &mat),
          "handing over the matrix");
  }

  std::vector<int> others_;
  std::array<int, 1> no_columns_{};
  std::array<double, 1> no_values_{};
};

void factorise(Mat factor, Mat matrix) {
  MatFactorInfo info;
  check(MatFactorInfoInitialize(&info), "starting");
  check(MatCholeskyFactorSymbolic(factor, matrix, nullptr, &info), "the analysis");
  check(MatCholeskyFactorNumeric(factor, matrix, &info), "the factorisation");
  // MUMPS tells the same to all ranks.
  MatFactorError error = MAT_FACTOR_NOERROR;
  check(MatFactorGetError(factor, &error), "the factorisation");
  if (error == MAT_FACTOR_OUTMEMORY)
    throw SolverFailure("linear solver: not enough memory. Use larger cells?");
  if (error != MAT_FACTOR_NOERROR)
    throw SolverFailure("linear solver: the stiffness matrix is not positive definite (MUMPS found "
                        "a pivot that is not). Is the tool supported, and no cell inverted?");
}

// The first rank holds the whole vector.
Vec view_of(double const* values, Eigen::Index n) {
  PetscInt const size = n;
  Vec vector = nullptr;
  check(ranks::count() == 1
            ? VecCreateSeqWithArray(all_ranks(), 1, size, values, &vector)
            : VecCreateMPIWithArray(all_ranks(), 1, size, PETSC_DETERMINE, values, &vector),
        "a vector");
  return vector;
}
} // namespace

struct SharedFactor::Handle {
  Mat mat = nullptr;
  Handle() = default;
  ~Handle() { MatDestroy(&mat); }
  Handle(Handle const&) = delete;
  Handle& operator=(Handle const&) = delete;
};

SharedFactor::SharedFactor(SparseMatrix const& rows) : handle_(std::make_unique<Handle>()) {
  PetscView const view(rows);
  check(MatGetFactor(view.mat, MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, &handle_->mat),
        "finding MUMPS");
  factorise(handle_->mat, view.mat);
}

SharedFactor::~SharedFactor() = default;

Eigen::VectorXd SharedFactor::solve(Eigen::VectorXd const& right_side) const {
  Eigen::VectorXd solution(right_side.size());
  struct Pair {
    Vec b = nullptr, x = nullptr;
    ~Pair() { VecDestroy(&b), VecDestroy(&x); }
  } vectors;
  vectors.b = view_of(right_side.data(), right_side.size());
  vectors.x = view_of(solution.data(), solution.size());
  check(MatSolve(handle_->mat, vectors.b, vectors.x), "the back-substitution");
  return solution;
}

namespace {
// MUMPS fills one triangle by columns, the lower one, and where several ranks share the work by
// rows, which PETSc turns: the upper one. The other triangle is its scratch paper, and it is that
// one which MatFactorCreateSchurComplement of PETSc 3.18 copies from several ranks.
Eigen::MatrixXd both_triangles(Eigen::Ref<Eigen::MatrixXd const, 0, Eigen::OuterStride<>> half) {
  if (ranks::count() == 1)
    return half.selfadjointView<Eigen::Lower>();
  return half.selfadjointView<Eigen::Upper>();
}
} // namespace

Eigen::MatrixXd shared_schur_complement(SparseMatrix const& rows, std::vector<int> const& keep) {
  struct Handles {
    Mat factor = nullptr;
    IS kept = nullptr;
    ~Handles() { MatDestroy(&factor), ISDestroy(&kept); }
  } own;
  PetscView const view(rows);
  check(MatGetFactor(view.mat, MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, &own.factor), "finding MUMPS");
  check(ISCreateGeneral(all_ranks(), keep.size(), keep.data(), PETSC_COPY_VALUES, &own.kept),
        "the interface");
  check(MatFactorSetSchurIS(own.factor, own.kept), "the interface");
  factorise(own.factor, view.mat);
  Mat half = nullptr;
  MatFactorSchurStatus status = MAT_FACTOR_SCHUR_UNFACTORED;
  check(MatFactorGetSchurComplement(own.factor, &half, &status), "the condensation");
  PetscInt stride = 0;
  PetscScalar const* values = nullptr;
  check(MatDenseGetLDA(half, &stride), "the condensation");
  check(MatDenseGetArrayRead(half, &values), "the condensation");
  auto const n = static_cast<Eigen::Index>(keep.size());
  Eigen::MatrixXd schur = both_triangles(Eigen::Map<Eigen::MatrixXd const, 0, Eigen::OuterStride<>>(
      values, n, n, Eigen::OuterStride<>(stride)));
  check(MatDenseRestoreArrayRead(half, &values), "the condensation");
  check(MatFactorRestoreSchurComplement(own.factor, &half, status), "the condensation");
  return schur;
}

} // namespace continuum
