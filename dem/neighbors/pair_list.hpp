#pragma once

#include "dem/vec3.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace dem {

/// Candidate pairs: the partners of row i are partner[start[i]] .. partner[start[i + 1] - 1], all
/// greater than i and ascending.
struct PairList {
  std::vector<std::uint32_t> start; ///< n_grains + 1
  std::vector<std::uint32_t> partner;

  std::span<std::uint32_t const> of(std::size_t i) const {
    return std::span(partner).subspan(start[i], start[i + 1] - start[i]);
  }
};

/// All pairs with |x_i - x_j| < reach_i + reach_j, by a hierarchy of grids: a grain lives in the
/// level whose cells just hold it and looks into its own and all coarser levels, so the cost a
/// grain does not depend on the ratio of sizes. A fast grain with a large reach is simply a large
/// grain.
/// @param position  [m], n
/// @param reach     [m], n, > 0: radius plus skin
/// Source: Krijgsman, Ogarko and Luding, Comput. Part. Mech. 1 (2014) 357.
PairList find_pairs(std::span<Vec3 const> position, std::span<double const> reach);

/// The same by comparing every pair: the oracle of `find_pairs`.
PairList find_pairs_by_brute_force(std::span<Vec3 const> position, std::span<double const> reach);

/// Rows in the order of a space-filling (Morton) curve through the box of the grains; ties keep
/// their order.
std::vector<std::uint32_t> order_along_curve(std::span<Vec3 const> position);

} // namespace dem
