#include "dem/packing/grain_counts.hpp"

#include "dem/expect.hpp"
#include "dem/spheres.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <sstream>

namespace dem {
namespace {

using Rows = std::vector<std::size_t>;

void validate(std::span<GrainShare const> shares, double mass) {
  double sum = 0.0;
  for (GrainShare const& share : shares) {
    std::ostringstream wrong;
    wrong << "powder: component " << share.component + 1 << ", diameter " << share.diameter
          << " m, density " << share.density << " kg/m^3, mass fraction " << share.mass_fraction;
    VALIDATE(std::isfinite(share.diameter) && share.diameter > 0.0 && share.diameter < 1.0,
             wrong.str() + ": the diameter is not usable (0 < d < 1 m)");
    VALIDATE(std::isfinite(share.density) && share.density > 0.0,
             wrong.str() + ": the density is not usable (grains need mass)");
    VALIDATE(share.mass_fraction >= 0.0 && share.mass_fraction <= 1.0,
             wrong.str() + ": the mass fraction is not in 0 to 1");
    sum += share.mass_fraction;
  }
  std::ostringstream numbers;
  numbers << "powder: mass fractions sum to " << sum
          << " (they must sum to 1). Is a class missing?";
  VALIDATE(std::abs(sum - 1.0) <= 1e-9, numbers.str());
  VALIDATE(std::isfinite(mass) && mass > 0.0, "powder: the total mass must be positive");
}

std::uint64_t whole(double count) {
  return static_cast<std::uint64_t>(std::max(0.0, count));
}

Rows rows_of_component(std::span<GrainShare const> shares, std::uint8_t component) {
  Rows rows;
  for (std::size_t k = 0; k < shares.size(); ++k)
    if (shares[k].component == component && shares[k].mass_fraction > 0.0)
      rows.push_back(k);
  return rows;
}

std::size_t lightest(std::span<GrainClass const> classes, Rows const& rows) {
  return *std::ranges::min_element(rows, {}, [&](std::size_t k) { return grain_mass(classes[k]); });
}

double mass_without(std::span<GrainClass const> classes, Rows const& rows, std::size_t left_out) {
  double mass = 0.0;
  for (std::size_t k : rows)
    if (k != left_out)
      mass += grain_mass(classes[k]) * static_cast<double>(classes[k].count);
  return mass;
}

/// Rounds the classes of `rows`; the lightest takes the balance of their common mass.
void count_component(std::vector<GrainClass>& classes, std::span<GrainShare const> shares,
                     Rows const& rows, double powder_mass) {
  double component_mass = 0.0;
  for (std::size_t k : rows)
    component_mass += shares[k].mass_fraction * powder_mass;
  auto const counts = [&](std::size_t k) {
    return shares[k].mass_fraction * powder_mass / grain_mass(classes[k]);
  };
  std::size_t const balance = lightest(classes, rows);
  for (std::size_t k : rows)
    classes[k].count = whole(std::round(counts(k)));
  if (mass_without(classes, rows, balance) > component_mass)
    for (std::size_t k : rows)
      classes[k].count = whole(std::floor(counts(k)));
  double const rest = component_mass - mass_without(classes, rows, balance);
  classes[balance].count = whole(std::round(rest / grain_mass(classes[balance])));
}

} // namespace

double grain_mass(GrainClass const& grains) {
  return grains.density * sphere_volume(0.5 * grains.diameter);
}

double total_mass(std::span<GrainClass const> classes) {
  double mass = 0.0;
  for (GrainClass const& grains : classes)
    mass += grain_mass(grains) * static_cast<double>(grains.count);
  return mass;
}

double solid_volume(std::span<GrainClass const> classes) {
  double volume = 0.0;
  for (GrainClass const& grains : classes)
    volume += sphere_volume(0.5 * grains.diameter) * static_cast<double>(grains.count);
  return volume;
}

std::vector<GrainClass> count_grains(std::span<GrainShare const> shares, double mass) {
  validate(shares, mass);
  std::vector<GrainClass> classes;
  std::set<std::uint8_t> components;
  Rows all;
  for (GrainShare const& share : shares) {
    if (share.mass_fraction > 0.0) {
      components.insert(share.component);
      all.push_back(classes.size());
    }
    classes.push_back({.diameter = share.diameter,
                       .density = share.density,
                       .material = share.material,
                       .component = share.component,
                       .count = 0});
  }
  for (std::uint8_t component : components)
    count_component(classes, shares, rows_of_component(shares, component), mass);

  std::size_t const balance = lightest(classes, all);
  double const rest = mass - mass_without(classes, all, balance);
  classes[balance].count = whole(std::round(rest / grain_mass(classes[balance])));
  std::ostringstream numbers;
  numbers << "powder: a total mass of " << mass << " kg gives no grain (the lightest weighs "
          << grain_mass(classes[balance]) << " kg). Is the unit right?";
  VALIDATE(total_mass(classes) > 0.0, numbers.str());
  return classes;
}

} // namespace dem
