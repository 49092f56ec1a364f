#include "coupling/measured/channel_kinds.hpp"

#include <algorithm>

namespace coupling::measured {

std::span<QuantityKind const> channel_kinds() {
  static constexpr QuantityKind kinds[] = {{"punch_gap", Physical::length},
                                           {"upper_punch_force", Physical::force},
                                           {"lower_punch_force", Physical::force},
                                           {"wall_radial_pressure", Physical::modulus},
                                           {"ejection_force", Physical::force}};
  return kinds;
}

std::span<QuantityKind const> scalar_kinds() {
  static constexpr QuantityKind kinds[] = {
      {"compact_height", Physical::length},   {"compact_mass", Physical::mass},
      {"compact_diameter", Physical::length}, {"porosity", Physical::ratio},
      {"max_force", Physical::force},         {"ejection_force", Physical::force},
      {"gap_at_peak", Physical::length},      {"dead_weight", Physical::force}};
  return kinds;
}

QuantityKind const* find_kind(std::span<QuantityKind const> kinds, std::string_view name) {
  auto const found = std::ranges::find(kinds, name, &QuantityKind::name);
  return found == kinds.end() ? nullptr : &*found;
}

std::vector<std::string> names_of(std::span<QuantityKind const> kinds) {
  std::vector<std::string> names;
  for (auto const& kind : kinds)
    names.emplace_back(kind.name);
  return names;
}

} // namespace coupling::measured
