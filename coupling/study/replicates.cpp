#include "coupling/study/replicates.hpp"

#include <algorithm>

namespace coupling::study {

std::vector<std::vector<int>> replicates(Eigen::MatrixXd const& coded) {
  constexpr double same = 1e-9;
  std::vector<std::vector<int>> points;
  for (int run = 0; run < coded.rows(); ++run) {
    auto const stands_there = [&](std::vector<int> const& point) {
      return (coded.row(run) - coded.row(point.front())).cwiseAbs().maxCoeff() < same;
    };
    auto const found = std::ranges::find_if(points, stands_there);
    if (found == points.end())
      points.push_back({run});
    else
      found->push_back(run);
  }
  return points;
}

PureError pure_error(Eigen::MatrixXd const& coded, Eigen::VectorXd const& response) {
  PureError error{0.0, 0};
  for (auto const& point : replicates(coded)) {
    Eigen::VectorXd const values = response(point);
    error.ss += (values.array() - values.mean()).square().sum();
    error.df += static_cast<int>(point.size()) - 1;
  }
  return error;
}

} // namespace coupling::study
