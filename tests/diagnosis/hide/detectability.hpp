#pragma once

#include "tests/diagnosis/hide/cases.hpp"

#include <Eigen/Core>

namespace hidden {

/// How far an effect stands out of what calibration and scatter can absorb, by the generator's own
/// linear model of the fitted runs at the case's powder (diagnosis note 2b):
///   lambda = |P w|,  w = L^-1 (y(effect) - y(none)),  P projects E and CED out,
///   Sigma  = sensors + repeats (mass, packing, friction, zeros) + tolerance 0.3 % of y.
struct Signatures {
  Eigen::MatrixXd nuisance; ///< whitened directions of E and CED, one prior standard deviation each
  Eigen::MatrixXd effects;  ///< whitened, projected signatures of the case's effects, in columns
  double lambda(int k) const { return effects.col(k).norm(); }
  double lambda() const; ///< of all together
};

Signatures signatures_of(Case const& hidden_case);

} // namespace hidden
