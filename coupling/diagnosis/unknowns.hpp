#pragma once

#include "coupling/diagnosis/model.hpp"

namespace coupling::diagnosis {

enum class SizePriors {
  physical, ///< as the mechanisms say
  flat      ///< none: for intervals by the likelihood
};

/// The unknowns of a hypothesis in units of their priors: calibrated parameters, then for every
/// active mechanism its size and its shape parameters. u = 0 is the prior mean, or size 0.
class Unknowns {
public:
  /// @throws dem::InvalidInput for an active mechanism that is not there or is given twice
  Unknowns(Model const& model, std::vector<int> active, SizePriors size_priors);

  Eigen::Index size() const { return low_.size(); }
  std::vector<int> const& active() const { return active_; }
  Eigen::Index n_calibrated() const { return n_calibrated_; }
  Eigen::Index place_of_size(int mechanism) const; ///< its index in u

  /// Its own unknowns among those of a hypothesis that has more causes.
  Eigen::VectorXd out_of(Unknowns const& wider, Eigen::VectorXd const& u) const;

  Parameters parameters(Eigen::VectorXd const& u) const;
  Eigen::VectorXd const& low() const { return low_; }
  Eigen::VectorXd const& high() const { return high_; }

  /// rho(u) with -ln prior = rho^2 / 2 + constant: u, or for Student's t with 4 degrees of freedom
  /// sign(u) sqrt(5 ln(1 + u^2 / 4)); 0 without a prior. [n]
  Eigen::VectorXd prior_residual(Eigen::VectorXd const& u) const;
  Eigen::VectorXd prior_slope(Eigen::VectorXd const& u) const;     ///< d rho / du, [n]
  Eigen::VectorXd prior_curvature(Eigen::VectorXd const& u) const; ///< d^2 (rho^2 / 2) / du^2, [n]
  /// ln of the prior's density at 0 over that of the standard normal, summed: 0 but for Student's
  /// t, ln(0.375 sqrt(2 pi)) each. The factor 2 of one-sided sizes is not in it.
  double log_prior_height() const;

private:
  enum class Prior { normal, student, flat };
  void append(double low, double high, Prior prior);

  Model const* model_;
  std::vector<int> active_;
  Eigen::Index n_calibrated_;
  Eigen::VectorXd low_, high_;
  std::vector<Prior> priors_;
};

} // namespace coupling::diagnosis
