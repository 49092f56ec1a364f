#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace continuum {

/// A disc of quadrilaterals: a rounded square of m x m cells, and rings of 4 m cells round it.
struct Disc {
  std::vector<Eigen::Vector2d> points = {};
  std::vector<std::array<unsigned, 4>> quads = {};        ///< lexicographic, right-handed
  std::vector<std::array<Eigen::Vector2d, 9>> nodes = {}; ///< of each quad, 3 j + i at (i/2, j/2)
  std::vector<unsigned> rim = {};                         ///< counter-clockwise from -45 degrees
  std::size_t n_inner = 0;                                ///< quads inside the innermost circle
};

/// @param circles  radii [m], ascending: the rings between the square and the first blend from the
///                 one to the other, the later ones are circular, one ring between two radii
/// @param m        cells on a side of the square, even
/// @param n_rings  between the square and the first circle
Disc mesh_disc(std::vector<double> const& circles, unsigned m, unsigned n_rings);

} // namespace continuum
