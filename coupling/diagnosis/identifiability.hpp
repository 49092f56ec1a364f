#pragma once

#include "coupling/diagnosis/signatures.hpp"

#include <vector>

namespace coupling::diagnosis {

constexpr double rival_scales = 3.0; ///< a rival's size is looked for within this many prior scales
constexpr double separable = 4.0;    ///< standard uncertainties apart: below, two are confounded

/// What an effect leaves when a rival imitates it as well as it can:
///   min over b in [-3 s, 3 s] (or [0, 3 s]) and the variants of its shape of |effect - b w|,
/// in standard uncertainties. Source: diagnosis note 2d.
/// @param effect  P L^-1 (f(a_i) - f(0)), [n_extended]
double separation(Eigen::VectorXd const& effect, Signature const& rival);

/// Delta_ij of every mechanism at the size `sizes[i]` [unit] from every other, n x n; infinite on
/// the diagonal. Not symmetric: the bounds on the rival's size are not.
Eigen::MatrixXd separations(SignatureLibrary const& library, Eigen::VectorXd const& sizes);

/// Connected components of "Delta_ij or Delta_ji below the threshold", ascending;
/// what nothing resembles stands alone.
std::vector<std::vector<int>> confounded_groups(Eigen::MatrixXd const& separations,
                                                double threshold = separable);

/// Collinearity index 1 / sqrt(least eigenvalue) of the normalised signatures of some mechanisms;
/// above 10 they cannot be told apart together even where pairs can. Infinite where one is unseen.
/// Source: Brun, Reichert, Kuensch, Water Resour. Res. 37 (2001) 1015.
double collinearity_index(SignatureLibrary const& library, std::vector<int> const& mechanisms);

} // namespace coupling::diagnosis
