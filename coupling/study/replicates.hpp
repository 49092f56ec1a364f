#pragma once

#include <Eigen/Core>

#include <vector>

namespace coupling::study {

/// Runs of a design that stand at the same point: for each different point its rows, in the order
/// of the runs. Coded values that differ by less than 1e-9 are the same.
std::vector<std::vector<int>> replicates(Eigen::MatrixXd const& coded);

/// Spread of the response among runs at the same point.
struct PureError {
  double ss; ///< sum over points of the squared departures from the point's mean
  int df;    ///< n_runs - n_points
};

PureError pure_error(Eigen::MatrixXd const& coded, Eigen::VectorXd const& response);

} // namespace coupling::study
