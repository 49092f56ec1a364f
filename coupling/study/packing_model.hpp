#pragma once

#include <vector>

namespace coupling::study {

/// Grains of one size in a mixture.
struct GrainClass {
  double size;    ///< diameter, any unit, > 0; only ratios count
  double share;   ///< of the solid volume, >= 0; all shares are scaled to a sum of 1
  double packing; ///< beta, virtual packing density of this size alone [1], 0 < beta < 1
};

/// De Larrard's compressible packing model: solid fraction Phi of a mixture. With classes in order
/// of falling size, loosening a and wall effect b,
///   gamma_i = beta_i / (1 - sum_{j<i} (1 - beta_i + b_ij beta_i (1 - 1/beta_j)) y_j
///                         - sum_{j>i} (1 - a_ij beta_i / beta_j) y_j),
///   a_ij = sqrt(1 - (1 - d_j/d_i)^1.02),  b_ij = 1 - (1 - d_i/d_j)^1.50,
///   K = sum_i (y_i / beta_i) / (1/Phi - 1/gamma_i).
/// One size alone: Phi = beta K / (1 + K).
/// Source: de Larrard, Concrete Mixture Proportioning (1999), chapter 1.
/// @param compaction_index  K: 4.1 poured, 4.75 rodded, 9 vibrated and pressed
/// @returns  Phi [1]; porosity is 1 - Phi
/// @throws dem::InvalidInput for sizes, shares, packings or an index that are none
double packed_fraction(std::vector<GrainClass> classes, double compaction_index);

/// beta for which one size alone packs to Phi:  beta = Phi (1 + K) / K.
double virtual_packing(double packed_alone, double compaction_index);

} // namespace coupling::study
