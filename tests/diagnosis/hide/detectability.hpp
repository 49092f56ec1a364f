#pragma once

#include "tests/diagnosis/hide/cases.hpp"

#include <Eigen/Dense>

#include <vector>

namespace hidden {

/// How far an effect stands out of what calibration and scatter can absorb, by the generator's own
/// linear model of the fitted runs at the case's powder (diagnosis note 2b):
///   lambda = |P w|,  w = L^-1 (y(effect) - y(none)),  P projects E and CED out,
///   Sigma  = sensors + repeats (mass, packing, friction, zeros) + tolerance 0.3 % of y
///            + the simulation's own departures (simulated_departures), alike in all runs.
class Detector {
public:
  explicit Detector(Case const& of);

  double lambda(std::vector<HiddenEffect> const& hidden) const;
  /// Delta to the nearest single rival of the library, up to three prior sizes either way (2d):
  ///   min_b |w - b w_rival|.
  struct Rival {
    Effect effect;
    double separation;
  };
  std::vector<Rival> rivals(HiddenEffect const& hidden) const;
  /// The size at which lambda is the target, by secants on the logarithms, within 5 prior sizes.
  double size_for(HiddenEffect const& hidden, double target) const;

private:
  Eigen::VectorXd signature(std::vector<HiddenEffect> const& hidden) const;
  Eigen::VectorXd projected(Eigen::VectorXd const& moved) const;

  Case case_;
  Eigen::VectorXd base_;
  Eigen::LLT<Eigen::MatrixXd> root_;
  Eigen::MatrixXd nuisance_; ///< whitened, one prior standard deviation of E and CED each
};

} // namespace hidden
