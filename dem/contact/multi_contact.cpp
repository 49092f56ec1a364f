#include "dem/contact/multi_contact.hpp"

#include "dem/contact/wall_meeting.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

/// b K / V of a grain [Pa/m^3].
double stiffness_per_volume(World const& world, std::size_t i, double coefficient) {
  Material const& m = world.materials[world.grains.material[i]];
  double const bulk_modulus = m.young_modulus / (3.0 * (1.0 - 2.0 * m.poisson_ratio));
  return coefficient * bulk_modulus / sphere_volume(world.grains.radius[i]);
}

/// Volumes that a block's contacts displace, slot by slot.
template <class U>
void sum_volumes(World const& world, ContactBlock<U> const& block, std::vector<double>& slots) {
  Spheres const& g = world.grains;
  slots.assign(block.rows.size(), 0.0);
  for (std::size_t k = 0; k < block.n_pairs; ++k) {
    std::uint32_t const i = block.rows[block.owner[k]], j = block.rows[block.partner[k]];
    double const square = (g.position[i] - g.position[j]).squaredNorm();
    double const sum = g.radius[i] + g.radius[j];
    double const square_gap = sum * sum - square;
    if (square_gap <= 0.0)
      continue;
    double const volume =
        displaced_volume(g.radius[i] * g.radius[j] / sum, square_gap / (sum + std::sqrt(square)));
    slots[block.owner[k]] += volume;
    slots[block.partner[k]] += volume;
  }
  std::vector<SurfacePoint> found;
  for (std::size_t k = 0; k < block.walls.size(); ++k) {
    WallContact const& wall = block.walls[k];
    WallYield const* const yield = block.yields.empty() ? nullptr : &block.yields[k];
    double const radius = g.radius[wall.owner];
    double const overlap =
        radius - meet_wall(world.tools[wall.tool], wall, yield, world.window_time,
                           g.position[wall.owner], radius, found)
                     .distance;
    if (overlap > 0.0)
      slots[wall.owner - block.first_row] += displaced_volume(radius, overlap);
  }
}

} // namespace

template <class T>
template <class U>
void CrowdingField<T>::form(World const& world, ContactLists<U> const& lists, double coefficient) {
  if (coefficient == 0.0)
    return grains_.clear();
  std::size_t const n = world.grains.size();
  grains_.resize(n);
  own_.resize(n);
  halo_.resize(lists.halo_loads.size());
#pragma omp parallel if (lists.blocks.size() > 1)
  {
    std::vector<double> slots;
#pragma omp for schedule(static)
    for (std::size_t b = 0; b < lists.blocks.size(); ++b) {
      ContactBlock<U> const& block = lists.blocks[b];
      sum_volumes(world, block, slots);
      std::copy_n(slots.data(), block.n_rows(), own_.data() + block.first_row);
      for (std::size_t s = block.n_rows(); s < slots.size(); ++s)
        halo_[block.halo_place[s - block.n_rows()]] = slots[s];
    }
#pragma omp for schedule(static)
    for (std::size_t i = 0; i < n; ++i) {
      double volume = own_[i];
      for (std::uint32_t h = lists.halo_start[i]; h < lists.halo_start[i + 1]; ++h)
        volume += halo_[h];
      double const stiffness = stiffness_per_volume(world, i, coefficient);
      grains_[i] = {static_cast<T>(stiffness * volume), static_cast<T>(stiffness)};
    }
  }
}

template <class T> std::size_t CrowdingField<T>::bytes() const {
  return grains_.capacity() * sizeof(Crowding<T>) +
         (own_.capacity() + halo_.capacity()) * sizeof(double);
}

template class CrowdingField<float>;
template class CrowdingField<double>;
template void CrowdingField<float>::form(World const&, ContactLists<float> const&, double);
template void CrowdingField<double>::form(World const&, ContactLists<float> const&, double);
template void CrowdingField<double>::form(World const&, ContactLists<double> const&, double);

} // namespace dem
