#pragma once

#include "coupling/diagnosis/observations.hpp"
#include "coupling/diagnosis/unknowns.hpp"
#include "coupling/diagnosis/whitening.hpp"

#include <optional>

namespace coupling::diagnosis {

/// Measured rows against a model under one error model.
struct Comparison {
  Model const* model;     ///< outlives it
  Eigen::VectorXd target; ///< y - b, [n_rows]
  Whitener whitener;      ///< of Sigma
};

struct FitSettings {
  SizePriors size_priors = SizePriors::physical;
  int most_steps = 60;
  double least_fall = 1e-6; ///< of chi^2: a step that promises less is the end
  double difference = 1e-3; ///< step of the slopes, in units of the priors
};

/// One unknown that stays where it is.
struct HeldUnknown {
  Eigen::Index place; ///< in u
  double value;       ///< in units of its prior
};

struct Fit {
  std::vector<int> active;
  Parameters at;
  Eigen::VectorXd unknowns;  ///< in units of their priors, as Unknowns orders them
  Eigen::VectorXd predicted; ///< f, [n_rows]
  Eigen::VectorXd residual;  ///< L^-1 (y - b - f), [n_rows]
  Eigen::MatrixXd slopes;    ///< L^-1 df/du, n_rows x n_unknowns
  double chi_squared;        ///< of the rows alone
  double prior_sum;          ///< sum of rho^2
  bool has_come_to_rest;

  double objective() const { return chi_squared + prior_sum; }
};

/// Least  |L^-1 (y - b - f(u))|^2 + |rho(u)|^2  inside the bounds, by Levenberg's and Marquardt's
/// method on the unknowns that no bound holds back, slopes by central differences.
/// Our own rather than Ceres: Debian's Ceres is built with Eigen at another alignment than our
/// architecture flags give, and the priors' bounds need no more than this.
/// Source: Nocedal, Wright, Numerical Optimization, 2nd ed. (2006), sections 10.3 and 16.7.
/// @param start  in units of the priors, [n_unknowns]; moved inside the bounds
Fit fit_hypothesis(Comparison const& comparison, std::vector<int> const& active,
                   Eigen::VectorXd const& start, FitSettings const& settings = {},
                   std::optional<HeldUnknown> held = {});

/// The calibrated parameters alone, from their prior means.
Fit fit_baseline(Comparison const& comparison, FitSettings const& settings = {});

} // namespace coupling::diagnosis
