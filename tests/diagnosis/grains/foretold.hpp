#pragma once

#include "tests/diagnosis/grains/grain_causes.hpp"
#include "tests/diagnosis/grains/laboratory.hpp"

#include <Eigen/Dense>

#include <vector>

namespace hidden {

/// Packings of the simulation that a diagnosis is given, and of the pilots: none of the data's.
constexpr std::uint64_t first_simulated = 900;
constexpr int n_simulated = 8, n_pilots = 2;

/// How far effects stand out on this bed, as `hide` foretells it for its press (diagnosis note 2b):
///   lambda = |P L^-1 (y(effect) - y(none))|,  P projects E and CED out, priors 15 % and 30 %
///   Sigma  = gauges + repeats (mass 0.3 %, wall friction 3 %, zeros) + tau^2 K(0)
///            + tau_bed^2 (1/n + 1/8) K(rho)
/// at equal commanded gaps, upper and lower force and radial pressure. K: reading times reading,
/// Matern 3/2 over the cycle, rho between channels; tau = 0.3 %. By tau_bed and rho a packing of
/// this bed scatters, the likeliest for the simulated packings; the data are the mean of n
/// packings, the simulation of 8. Causes between grains are simulated at a trial size with two
/// packings (pilots), the square of lambda less what other packings would give; the others are
/// exact. Sizes are proportional to lambda.
class Foretold {
public:
  Foretold(Simulations const& simulations, int n_packings);

  /// lambda of a size of 1, 0 where the trial does not stand out of the chaos.
  double per_unit(Effect effect) const;
  double bed_scatter() const { return bed_scatter_; }         ///< tau_bed [1]
  double bed_correlation() const { return bed_correlation_; } ///< of that between channels [1]

private:
  using Curves = std::vector<Curve>; ///< one of each pilot's packing
  Curves pilots(std::string const& change, GrainPress const& press) const;
  Eigen::VectorXd rows(std::vector<Moment> const& moments) const;
  /// Change of the rows from the pilot without an effect, of the k-th packing.
  Eigen::VectorXd change_of(Curves const& curves, std::size_t k, Effects const& effects,
                            Scatter const& scatter) const;
  /// Mean change of the rows from the pilots without an effect.
  Eigen::VectorXd moved(Curves const& curves, Effects const& effects = {},
                        Scatter const& scatter = {}) const;
  Eigen::MatrixXd gauge_covariance() const;
  Eigen::MatrixXd reading_kernel(double between_channels) const;
  Eigen::MatrixXd repeat_covariance(Curves const& opened, Curves const& rough_wall) const;
  void find_bed_scatter(Eigen::MatrixXd const& rest);
  Eigen::VectorXd projected(Eigen::VectorXd const& change) const;
  double machine_lambda(Effect effect, Curves const& opened) const;
  double grain_lambda(GrainCause const& cause) const;

  Simulations simulations_;
  Curves clean_;
  double peak_;
  std::vector<double> closing_, opening_; ///< commanded gaps of the rows [m]
  Eigen::VectorXd base_;
  Eigen::LLT<Eigen::MatrixXd> root_;
  Eigen::MatrixXd nuisance_; ///< a prior standard deviation each
  std::vector<double> lambda_per_unit_;
  double bed_scatter_ = 0.0, bed_correlation_ = 0.0;
};

} // namespace hidden
