#include "continuum/tool/raise_cell.hpp"

#include <algorithm>

namespace continuum {

void raise_cell(HexMesh::CellNodes& nodes, std::array<bool, 27> const& is_known) {
  auto const digits = [](unsigned n) { return std::array{n % 3, n / 3 % 3, n / 9}; };
  auto const n_halves = [&](unsigned n) { return std::ranges::count(digits(n), 1u); };
  // Edges before faces before the cell: each needs those before it.
  for (int const kind : {1, 2, 3})
    for (unsigned n = 0; n < 27; ++n) {
      if (is_known[n] || n_halves(n) != kind)
        continue;
      Eigen::Vector3d corners = Eigen::Vector3d::Zero(), sides = Eigen::Vector3d::Zero();
      for (unsigned m = 0; m < 27; ++m) {
        bool is_around = true; // on the edge or face that n stands in the middle of
        for (int c = 0; c < 3; ++c)
          is_around = is_around && (digits(n)[c] == 1 || digits(m)[c] == digits(n)[c]);
        if (is_around && n_halves(m) == 0)
          corners += nodes[m];
        else if (is_around && n_halves(m) == 1)
          sides += nodes[m];
      }
      nodes[n] = kind == 1   ? Eigen::Vector3d(0.5 * corners)
                 : kind == 2 ? Eigen::Vector3d(0.5 * sides - 0.25 * corners)
                             : Eigen::Vector3d(0.25 * sides - 0.25 * corners);
    }
}

} // namespace continuum
