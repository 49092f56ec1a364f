#pragma once

#include "tests/diagnosis/hide/cases.hpp"

#include <Eigen/Dense>

#include <vector>

namespace hidden {

/// How far an effect stands out of what calibration and scatter can absorb, by the generator's own
/// linear model of the fitted runs at the case's powder (diagnosis note 2b):
///   lambda = |P w|,  w = L^-1 (y(effect) - y(none)),  P projects E and CED out,
///   Sigma  = sensors (that of the gap by the slope, alike in all gauges) + repeats (mass, packing,
///   friction, zeros) + tolerance 0.3 % of y
///            + the simulation's own departures (simulated_departures), alike in all runs.
class Detector {
public:
  explicit Detector(Case const& of);

  double lambda(std::vector<HiddenEffect> const& hidden) const;
  /// Delta to the nearest single rival of the library, up to three prior sizes either way (2d),
  /// each at its size, and E and CED calibrated with it: min_b |P_b L^-1 (y(effect) - y(rival of
  /// b))|.
  struct Rival {
    Effect effect;
    double separation;
  };
  std::vector<Rival> rivals(HiddenEffect const& hidden) const;
  /// The size at which lambda is the target, by secants on the logarithms, within 5 prior sizes.
  double size_for(HiddenEffect const& hidden, double target) const;

private:
  Eigen::VectorXd moved_by(std::vector<HiddenEffect> const& hidden) const;
  /// Whitened, without what E (by `stiffer` a prior standard deviation) and CED can take over.
  Eigen::VectorXd projected(Eigen::VectorXd const& moved, Eigen::VectorXd const& stiffer) const;
  double nearest(Eigen::VectorXd const& own, Effect rival) const;

  Case case_;
  Eigen::VectorXd base_;
  Eigen::LLT<Eigen::MatrixXd> root_;
  Eigen::VectorXd modulus_, cohesion_; ///< one prior standard deviation of each
};

} // namespace hidden
