#include "continuum/tool/shared_inverse.hpp"

#include "continuum/errors.hpp"
#include "continuum/ranks.hpp"

#include <Eigen/Cholesky>

#include <algorithm>

namespace continuum {

namespace {
using InPlace = Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>;
constexpr Eigen::Index width = 256; // columns of a block: enough for fast products

void refuse(Eigen::ComputationInfo info) {
  if (info != Eigen::Success)
    throw SolverFailure("the condensed stiffness is not positive definite. Do moduli differ by "
                        "many orders of magnitude?");
}

// Columns begin..begin + n of (L L^T)^-1 from row `begin` down. What is above does not matter to
// them: it meets zeros on the way forward, and on the way back the rows below do not ask for it.
Eigen::MatrixXd columns_of_inverse(Eigen::Ref<Eigen::MatrixXd const> const& L, Eigen::Index begin) {
  Eigen::Index const left = L.rows() - begin;
  Eigen::MatrixXd block = Eigen::MatrixXd::Identity(left, std::min(width, left));
  auto const corner = L.bottomRightCorner(left, left);
  corner.triangularView<Eigen::Lower>().solveInPlace(block);
  corner.transpose().triangularView<Eigen::Upper>().solveInPlace(block);
  return block;
}

// Blocks go to the ranks in turn, so that each gets long and short ones.
int owner(Eigen::Index begin) {
  return static_cast<int>(begin / width % ranks::count());
}

// The triangle L over the matrix, on every rank.
void factorise_everywhere(Eigen::MatrixXd& matrix) {
  for (Eigen::Index j = 0; j < matrix.cols(); ++j)
    ranks::broadcast(matrix.col(j).data(), matrix.rows());
  InPlace const factor(matrix);
  refuse(factor.info());
}

void collect(Eigen::MatrixXd const& L, Eigen::MatrixXd& inverse) {
  Eigen::Index const n = L.rows();
  for (Eigen::Index begin = 0; begin < n; begin += width) {
    Eigen::Index const left = n - begin;
    Eigen::MatrixXd block(left, std::min(width, left));
    if (owner(begin) == 0)
      block = columns_of_inverse(L, begin);
    else
      ranks::receive(block.data(), block.size(), owner(begin));
    inverse.block(begin, begin, left, block.cols()) = block;
  }
  inverse.triangularView<Eigen::StrictlyUpper>() = inverse.transpose();
}

void contribute(Eigen::MatrixXd const& L) {
  for (Eigen::Index begin = 0; begin < L.rows(); begin += width)
    if (owner(begin) == ranks::own()) {
      Eigen::MatrixXd const block = columns_of_inverse(L, begin);
      ranks::send(block.data(), block.size());
    }
}
} // namespace

Eigen::MatrixXd shared_inverse(Eigen::MatrixXd matrix) {
  Eigen::Index const n = matrix.rows();
  if (ranks::count() == 1) {
    Eigen::LLT<Eigen::MatrixXd> const factor(matrix);
    refuse(factor.info());
    return factor.solve(Eigen::MatrixXd::Identity(n, n));
  }
  Eigen::MatrixXd inverse;
  ranks::announce({.task = ranks::Task::invert, .size = static_cast<int>(n)});
  // Step by step: a rank that lacks the memory is heard before others wait for its columns.
  ranks::together([&] { inverse.resize(n, n); });
  ranks::together([&] { factorise_everywhere(matrix); });
  ranks::together([&] { collect(matrix, inverse); });
  return inverse;
}

void help_inverting(int size) {
  Eigen::MatrixXd matrix;
  ranks::together([&] { matrix.resize(size, size); });
  ranks::together([&] { factorise_everywhere(matrix); });
  ranks::together([&] { contribute(matrix); });
}

} // namespace continuum
