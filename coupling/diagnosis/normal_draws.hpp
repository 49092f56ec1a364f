#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace coupling::diagnosis {

/// Independent standard normal numbers by Box and Muller, n x n_draws. Draw k hangs on the seed and
/// k alone, so any number of draws begins with the same ones, on any number of threads.
Eigen::MatrixXd normal_draws(std::uint64_t seed, Eigen::Index n, int n_draws);

/// ln of the standard normal distribution function; accurate far into the lower tail, where the
/// function itself is below the smallest number.
double log_normal_cdf(double x);

} // namespace coupling::diagnosis
