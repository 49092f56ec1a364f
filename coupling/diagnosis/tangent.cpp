#include "coupling/diagnosis/tangent.hpp"

#include <Eigen/QR>

namespace coupling::diagnosis {

using Eigen::MatrixXd;

TangentSpace::TangentSpace(MatrixXd const& slopes) {
  auto const p = slopes.cols();
  MatrixXd extended(slopes.rows() + p, p);
  extended << slopes, MatrixXd::Identity(p, p);
  if (p == 0) {
    basis_ = extended;
    return;
  }
  Eigen::HouseholderQR<MatrixXd> const qr(extended);
  basis_ = qr.householderQ() * MatrixXd::Identity(extended.rows(), p);
}

MatrixXd TangentSpace::project_extended(MatrixXd const& rows) const {
  return rows - basis_ * (basis_.transpose() * rows);
}

MatrixXd TangentSpace::project(MatrixXd const& rows) const {
  MatrixXd extended = MatrixXd::Zero(n_extended(), rows.cols());
  extended.topRows(n_rows()) = rows;
  return project_extended(extended);
}

} // namespace coupling::diagnosis
