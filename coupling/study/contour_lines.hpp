#pragma once

#include <array>
#include <functional>
#include <vector>

namespace coupling::study {

/// Equally spaced values, both ends among them.
struct GridAxis {
  double low, high; ///< low < high
  int n;            ///< 2 or more

  double at(int k) const { return low + (high - low) * k / (n - 1); }
};

/// Points (x, y) in order. A line that closes ends with its first point; one that leaves the grid
/// does not.
using ContourLine = std::vector<std::array<double, 2>>;

/// Lines f(x, y) = level by marching squares: which cells a line crosses is seen at the grid's
/// nodes, so what is thinner than a cell can be missed; where it crosses an edge is solved to 1e-9
/// of the edge. A cell whose diagonals differ is decided by its middle.
/// Source: Lorensen, Cline, Computer Graphics 21 (1987) 163, in two dimensions; the root by
/// Alefeld, Potra, Shi, ACM TOMS 21 (1995) 327 (Boost.Math).
std::vector<ContourLine> contour_lines(std::function<double(double x, double y)> const& f,
                                       GridAxis const& x, GridAxis const& y, double level);

} // namespace coupling::study
