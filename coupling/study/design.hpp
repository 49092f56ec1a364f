#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

/// Designs of experiments in coded units: one row a run, one column a factor. A factor's low value
/// is -1, its high value 1 (study/coding.hpp).
namespace coupling::study {

/// Every combination of equally spaced levels from -1 to 1. The first factor changes slowest, as in
/// table 7 of the seed.
/// @param n_levels  of each factor, at least 2
/// @returns         coded [1], n_runs x n_factors, n_runs = product of the levels
/// @throws dem::InvalidInput without factors, for one level, for more than 100 000 runs
Eigen::MatrixXd full_factorial(std::vector<int> const& n_levels);

/// Where the axial points of a central composite design stand.
enum class AxialPoints {
  face_centred,  ///< at -1 and 1, corners too: three levels, nothing beyond low and high
  circumscribed, ///< at -alpha and alpha beyond low and high, alpha = 2^(k/4): rotatable
  inscribed      ///< at -1 and 1, corners at -1/alpha and 1/alpha: rotatable within low and high
};

/// 2^k corners, then 2 k axial points, then `n_centre` times the centre. With `face_centred`, three
/// factors and one centre these are the 15 runs of table 3 of the seed.
/// Source: Box and Wilson, J. R. Stat. Soc. B 13 (1951) 1; Myers, Montgomery, Anderson-Cook,
/// Response Surface Methodology, 4th ed. (2016), section 8.4.1.
/// @returns  coded [1], (2^k + 2 k + n_centre) x k
/// @throws dem::InvalidInput for fewer than two factors, a negative number of centres, too many
/// runs
Eigen::MatrixXd central_composite(int n_factors, AxialPoints axial, int n_centre);

/// Each factor's range is cut into `n_runs` equal cells; each cell's middle is used once. Of 1000
/// such designs drawn from `seed` the one whose closest two runs are furthest apart (maximin); the
/// first of equals. The same on every platform.
/// Source: McKay, Beckman, Conover, Technometrics 21 (1979) 239; Johnson, Moore, Ylvisaker, J.
/// Stat. Plan. Inference 26 (1990) 131.
/// @returns  coded [1], n_runs x n_factors
/// @throws dem::InvalidInput without factors, for fewer than two runs or more than 100 000
Eigen::MatrixXd latin_hypercube(int n_factors, int n_runs, std::uint64_t seed);

/// Distance of the two closest runs.  [1], coded
double closest_pair(Eigen::MatrixXd const& design);

} // namespace coupling::study
