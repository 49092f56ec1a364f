#pragma once

#include <Eigen/Core>

namespace coupling::diagnosis {

/// Wald's and Wolfowitz' runs of equal sign in a series around 0: n_runs - expected and its
/// variance, given the numbers m and n of positive and negative values,
///   expected = 2 m n / (m + n) + 1,  variance = (expected - 1)(expected - 2) / (m + n - 1).
/// A zero counts as positive. Smooth misfit has too few runs.
/// Source: Wald, Wolfowitz, Ann. Math. Stat. 11 (1940) 147.
struct RunsCount {
  double excess, variance;
};
RunsCount count_runs(Eigen::VectorXd const& series);

/// Ljung's and Box' Q = n (n + 2) sum_k r_k^2 / (n - k), k = 1 .. lags, r_k the autocorrelation
/// about the mean; 0 for a constant series. Source: Ljung, Box, Biometrika 65 (1978) 297.
double ljung_box(Eigen::VectorXd const& series, int lags);

} // namespace coupling::diagnosis
