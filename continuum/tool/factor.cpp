#include "continuum/tool/factor.hpp"

#include "continuum/ranks.hpp"
#include "continuum/session.hpp"
#include "continuum/tool/shared_factor.hpp"

namespace continuum {

namespace {
using ranks::Task;

int next_number() {
  static int last = 0;
  return ++last;
}
} // namespace

struct CholeskyFactor::Factor {
  int number = next_number();
  int size;
  std::unique_ptr<SharedFactor> shared;

  explicit Factor(SparseMatrix const& matrix) : size(static_cast<int>(matrix.rows())) {
    ranks::announce({.task = Task::factorise, .factor = number, .size = size});
    ranks::together([&] { shared = std::make_unique<SharedFactor>(matrix); });
  }
  ~Factor() {
    if (Session::is_active())
      ranks::announce({.task = Task::forget, .factor = number});
  }
  Factor(Factor const&) = delete;
  Factor& operator=(Factor const&) = delete;
};

CholeskyFactor::CholeskyFactor(SparseMatrix const& matrix)
    : factor_(std::make_unique<Factor>(matrix)) {}

CholeskyFactor::~CholeskyFactor() = default;
CholeskyFactor::CholeskyFactor(CholeskyFactor&&) noexcept = default;
CholeskyFactor& CholeskyFactor::operator=(CholeskyFactor&&) noexcept = default;

Eigen::VectorXd CholeskyFactor::solve(Eigen::VectorXd const& right_side) const {
  Eigen::VectorXd solution;
  ranks::announce({.task = Task::solve, .factor = factor_->number});
  ranks::together([&] { solution = factor_->shared->solve(right_side); });
  return solution;
}

Eigen::MatrixXd schur_complement(SparseMatrix const& matrix, std::vector<int> const& keep) {
  Eigen::MatrixXd schur;
  ranks::announce({.task = Task::condense, .size = static_cast<int>(matrix.rows())});
  ranks::together([&] { schur = shared_schur_complement(matrix, keep); });
  return schur;
}

} // namespace continuum
