#pragma once

#include "coupling/diagnosis/fit.hpp"

namespace coupling::diagnosis {

/// Laplace's approximation of ln of the integral of likelihood times priors over all unknowns of a
/// fit, up to a constant that all hypotheses under one Sigma share:
///   ln Z = -1/2 [chi^2 + sum rho^2] - 1/2 ln det(J'J + D) + ln heights
///          + sum over one-sided sizes of ln of (2 exp(g^2 / 2h) Phi(-g / sqrt(h)) or 2 Phi(u /
///          sd)),
/// J the whitened slopes in units of the priors, D the priors' curvature (0 where it is negative).
/// A one-sided size at 0 has the slope g and the curvature h = 1 / [(J'J + D)^-1]_uu of the
/// objective / 2; inside, sd = 1 / sqrt(h). Exact for linear models with normal priors and at
/// most one one-sided size, and with more if their estimates are uncorrelated. Other bounds are
/// taken as far away.
/// Source: diagnosis note 2c; MacKay, Information Theory (2003), ch. 27.
double log_evidence(Comparison const& comparison, Fit const& fit);

/// Standard uncertainties of the unknowns, sqrt diag (J'J + D)^-1, in units of the priors.
Eigen::VectorXd standard_uncertainties(Comparison const& comparison, Fit const& fit);

} // namespace coupling::diagnosis
