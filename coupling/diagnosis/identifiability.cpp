#include "coupling/diagnosis/identifiability.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace coupling::diagnosis {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double separation(VectorXd const& effect, Signature const& rival) {
  double least = effect.norm();
  for (Index v = 0; v < rival.projected.cols(); ++v) {
    auto const w = rival.projected.col(v);
    double const d2 = w.squaredNorm();
    if (d2 == 0.0)
      continue;
    double const b =
        std::clamp(w.dot(effect) / d2, rival.is_one_sided ? 0.0 : -rival_scales, rival_scales);
    least = std::min(least, (effect - b * w).norm());
  }
  return least;
}

MatrixXd separations(SignatureLibrary const& library, VectorXd const& sizes) {
  auto const n = static_cast<Index>(library.signatures.size());
  MatrixXd all = MatrixXd::Constant(n, n, no_bound);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      auto const& own = library.signatures[static_cast<std::size_t>(i)];
      if (i != j)
        all(i, j) = separation(sizes[i] / own.scale * own.projected.col(0),
                               library.signatures[static_cast<std::size_t>(j)]);
    }
  return all;
}

std::vector<std::vector<int>> confounded_groups(MatrixXd const& separations, double threshold) {
  auto const n = static_cast<int>(separations.rows());
  std::vector<int> group(static_cast<std::size_t>(n), -1);
  std::vector<std::vector<int>> groups;
  for (int seed = 0; seed < n; ++seed) {
    if (group[static_cast<std::size_t>(seed)] >= 0)
      continue;
    groups.push_back({seed});
    group[static_cast<std::size_t>(seed)] = seed;
    for (std::size_t k = 0; k < groups.back().size(); ++k)
      for (int j = 0; j < n; ++j) {
        int const i = groups.back()[k];
        if (group[static_cast<std::size_t>(j)] < 0 &&
            std::min(separations(i, j), separations(j, i)) < threshold) {
          group[static_cast<std::size_t>(j)] = seed;
          groups.back().push_back(j);
        }
      }
    std::ranges::sort(groups.back());
  }
  return groups;
}

double collinearity_index(SignatureLibrary const& library, std::vector<int> const& mechanisms) {
  MatrixXd const cosines = library.cosines()(mechanisms, mechanisms);
  Eigen::SelfAdjointEigenSolver<MatrixXd> const eigen(cosines);
  double const least = eigen.eigenvalues().minCoeff();
  return least > 0.0 ? 1.0 / std::sqrt(least) : no_bound;
}

} // namespace coupling::diagnosis
