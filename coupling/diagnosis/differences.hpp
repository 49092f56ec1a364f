#pragma once

#include "coupling/diagnosis/model.hpp"

namespace coupling::diagnosis {

/// Share of a mechanism's scale over which its signature is a difference. Large, since a kink or a
/// power law has no useful slope at size 0.
constexpr double signature_step = 0.25;

/// v = df / da of one mechanism around its size in `at`, [n_rows] [rows' units / size]: central
/// over +- signature_step scale, one-sided where a bound or the sign forbids the other side.
Eigen::VectorXd size_signature(Model const& model, Parameters const& at, int mechanism,
                               Eigen::Index n_rows);

/// Half the difference between one standard deviation more and less of each scatter, n_rows x
/// n_scatters [rows' units]: J diag(sd).
Eigen::MatrixXd scatter_changes(Model const& model, Parameters const& at, Eigen::Index n_rows);

/// What a mechanism's size in `at` does: f(at) - f(at without it), [n_rows].
Eigen::VectorXd change_by(Model const& model, Parameters const& at, int mechanism,
                          Eigen::Index n_rows);

} // namespace coupling::diagnosis
