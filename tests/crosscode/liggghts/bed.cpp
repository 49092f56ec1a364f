#include "tests/crosscode/liggghts/bed.hpp"

#include "dem/packing/grain_counts.hpp"
#include "dem/packing/level_grid.hpp"
#include "dem/packing/random_stream.hpp"
#include "dem/packing/relax_overlaps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace crosscode {
namespace {

std::array<dem::PackingComponent, 2> const components{{{"MgO", 3500.0, 0}, {"Al2O3", 3000.0, 1}}};

/// Largest first, as relax_overlaps needs them.
std::vector<dem::GrainClass> seed_classes(double total_mass) {
  std::array<dem::GrainShare, 5> const shares{{{3e-3, 3500.0, 0, 0, 0.8 * 0.15},
                                               {2e-3, 3500.0, 0, 0, 0.8 * 0.25},
                                               {1e-3, 3500.0, 0, 0, 0.8 * 0.25},
                                               {0.5e-3, 3500.0, 0, 0, 0.8 * 0.35},
                                               {0.5e-3, 3000.0, 1, 1, 0.2}}};
  return dem::count_grains(shares, total_mass);
}

dem::Vec3 anywhere(dem::FillVolume const& volume, dem::RandomStream& random) {
  double const off_axis = volume.radius * std::sqrt(random.uniform());
  double const angle = 2.0 * dem::pi * random.uniform();
  return {off_axis * std::cos(angle), off_axis * std::sin(angle), volume.height * random.uniform()};
}

} // namespace

std::span<dem::PackingComponent const> seed_components() {
  return components;
}

dem::Packing dense_bed(Bed const& bed) {
  dem::FillVolume const volume{.radius = bed.bore_diameter / 2.0, .height = bed.height};
  dem::RandomStream random(bed.seed);
  dem::Packing packing;
  std::vector<dem::Vec3> centres;
  std::vector<double> radii;
  for (dem::GrainClass const& grains : seed_classes(bed.total_mass))
    for (std::uint64_t n = 0; n < grains.count; ++n) {
      radii.push_back(grains.diameter / 2.0);
      centres.push_back(dem::clamp_inside(anywhere(volume, random), radii.back(), volume));
      packing.push_back({centres.back(), grains.diameter, grains.component});
    }
  if (!dem::relax_overlaps(centres, radii, volume, 20000).is_free)
    throw std::runtime_error("dense bed: grains still overlap (too dense). A larger height?");
  for (std::size_t i = 0; i < packing.size(); ++i)
    packing[i].position = centres[i];
  return packing;
}

double coordination(dem::Packing const& packing) {
  std::vector<std::size_t> order(packing.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater<>{}, [&](auto i) { return packing[i].diameter; });
  std::vector<double> radii;
  dem::Vec3 low = packing.front().position, high = low;
  for (std::size_t const i : order) {
    radii.push_back(packing[i].diameter / 2.0);
    low = low.cwiseMin(packing[i].position);
    high = high.cwiseMax(packing[i].position);
  }
  dem::LevelGrid grid(radii, low, high);
  std::size_t n_touching = 0;
  // Each grain looks at the larger and equal ones before it, which are all inserted by then.
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    dem::Vec3 const& x = packing[order[i]].position;
    grid.meet_near(i, x, 0.0, [&](std::uint32_t, dem::Vec3 const& other, double radius) {
      n_touching += (other - x).norm() < radii[i] + radius ? 1 : 0;
      return false;
    });
    grid.insert(i, x);
  }
  return 2.0 * static_cast<double>(n_touching) / static_cast<double>(packing.size());
}

double extent(dem::Packing const& packing) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (dem::PackedGrain const& g : packing) {
    low = std::min(low, g.position.z() - g.diameter / 2.0);
    high = std::max(high, g.position.z() + g.diameter / 2.0);
  }
  return high - low;
}

} // namespace crosscode
