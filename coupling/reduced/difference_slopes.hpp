#pragma once

#include "coupling/study/box_minimum.hpp"

#include <Eigen/Core>

namespace coupling::reduced {

/// Residuals with slopes by central differences, steps 1e-5 of the box's widths; an unknown that
/// the box holds has none. @param residual  u -> r, [n]
template <class ResidualAt>
study::ResidualsAt with_difference_slopes(ResidualAt residual, study::Box const& box) {
  return [residual, widths = Eigen::VectorXd(box.high - box.low)](Eigen::VectorXd const& u) {
    study::Residuals at{residual(u), {}};
    at.slopes.setZero(at.values.size(), u.size());
    for (Eigen::Index k = 0; k < u.size(); ++k) {
      double const step = 1e-5 * widths[k];
      Eigen::VectorXd more = u, less = u;
      more[k] += step, less[k] -= step;
      if (step > 0.0)
        at.slopes.col(k) = (residual(more) - residual(less)) / (2.0 * step);
    }
    return at;
  };
}

} // namespace coupling::reduced
