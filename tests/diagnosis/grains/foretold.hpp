#pragma once

#include "tests/diagnosis/grains/grain_causes.hpp"
#include "tests/diagnosis/grains/laboratory.hpp"

#include <Eigen/Dense>

#include <vector>

namespace hidden {

/// How far effects stand out on this bed, as `hide` foretells it for its press (diagnosis note 2b),
/// from pilots: simulations of one packing (seed 900) without and with each cause at its trial
/// size.
///   lambda = |P L^-1 (y(effect) - y(none))|,  P projects E and CED out, priors 15 % and 30 %
///   Sigma  = gauges + repeats (mass 0.3 %, onset 0.0012, wall friction 3 %, zeros) + tolerance 0.3
///   %
/// at equal commanded gaps, upper and lower force and radial pressure. The same packing pressed
/// over other time steps departs by `chaos`; squares of lambdas are taken less its square. Sizes
/// are proportional to lambda: a line through the trial.
class Foretold {
public:
  explicit Foretold(Simulations const& simulations);

  /// lambda of a size of 1, 0 where the trial does not stand out of the chaos.
  double per_unit(Effect effect) const;
  double chaos() const { return chaos_; }
  /// lambda of another packing, root mean square over five of them.
  double packings() const { return packings_; }

private:
  Eigen::VectorXd rows(std::vector<Moment> const& moments) const;
  Eigen::VectorXd rows(Curve const& curve) const;
  double length(Eigen::VectorXd const& moved) const;
  double machine_lambda(Effect effect, Curve const& opened) const;
  void weigh(Curve const& opened, Curve const& rough_wall);

  Simulations simulations_;
  Curve clean_;
  std::vector<double> closing_, opening_; ///< commanded gaps of the rows [m]
  Eigen::VectorXd base_;
  Eigen::LLT<Eigen::MatrixXd> root_;
  Eigen::MatrixXd nuisance_; ///< whitened, a prior standard deviation each
  std::vector<double> lambda_per_unit_;
  double chaos_ = 0.0, packings_ = 0.0;
};

} // namespace hidden
