#include "dem/measure/compact.hpp"

#include "dem/expect.hpp"
#include "dem/measure/contact_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dem {

bool is_in_compact(Spheres const& grains, std::size_t i, double floor) {
  return grains.position[i][2] > floor;
}

Extent compact_extent(Spheres const& grains, double floor) {
  Extent extent{.lowest = floor, .highest = floor, .n_grains = 0};
  for (std::size_t i = 0; i < grains.size(); ++i) {
    if (!is_in_compact(grains, i, floor))
      continue;
    double const z = grains.position[i][2], R = grains.radius[i];
    bool const is_first = extent.n_grains++ == 0;
    extent.lowest = is_first ? z - R : std::min(extent.lowest, z - R);
    extent.highest = is_first ? z + R : std::max(extent.highest, z + R);
  }
  return extent;
}

double ranked_height(Spheres const& grains, double floor, double share) {
  EXPECT(share > 0.0 && share <= 1.0);
  std::vector<double> tops;
  for (std::size_t i = 0; i < grains.size(); ++i)
    if (is_in_compact(grains, i, floor))
      tops.push_back(grains.position[i][2] + grains.radius[i]);
  if (tops.empty())
    return 0.0;
  auto const rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(tops.size())));
  auto const at_rank =
      tops.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
  std::ranges::nth_element(tops, at_rank);
  return *at_rank - compact_extent(grains, floor).lowest;
}

double solid_volume(Spheres const& grains, ContactStream const& contacts, double floor) {
  double solid = 0.0, lenses = 0.0;
  for (std::size_t i = 0; i < grains.size(); ++i)
    if (is_in_compact(grains, i, floor))
      solid += sphere_volume(grains.radius[i]);
  contacts.for_each([&](Contact const& contact) {
    if (contact.j != Contact::none && is_in_compact(grains, contact.i, floor) &&
        is_in_compact(grains, contact.j, floor))
      lenses += contact_lens(grains, contact);
  });
  return solid - lenses;
}

SeedPorosity seed_porosity(Spheres const& grains, ContactStream const& contacts, double bore_radius,
                           double floor) {
  EXPECT(bore_radius > 0.0);
  Extent const extent = compact_extent(grains, floor);
  double const solid = solid_volume(grains, contacts, floor);
  double const ranked = ranked_height(grains, floor);
  double const area = pi * bore_radius * bore_radius;
  auto const porosity = [&](double height) {
    return height > 0.0 ? 1.0 - solid / (area * height) : 1.0;
  };
  return {.porosity = porosity(extent.height()),
          .height = extent.height(),
          .ranked_porosity = porosity(ranked),
          .ranked_height = ranked,
          .solid_volume = solid,
          .n_grains = extent.n_grains};
}

} // namespace dem
