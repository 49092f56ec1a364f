#include "coupling/breakage.hpp"

#include "coupling/press_measures.hpp"
#include "dem/step/advance.hpp"
#include "dem/step/crush.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace coupling {
namespace {

/// A well mixed number. Source: Steele, Lea and Flood, OOPSLA (2014): splitmix64.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Rows of the grains that have reached their strength, by id: rows are the threads' and lists'
/// business.
std::vector<std::uint32_t> broken_rows(Press const& press) {
  dem::Spheres const& grains = press.world.grains;
  BreakageLaw const& law = press.setup.breakage;
  auto const stress = largest_stress(press.world);
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < grains.size(); ++i) {
    double const diameter = 2.0 * grains.radius[i];
    if (stress[i] > 0.0 && diameter > law.smallest_diameter &&
        stress[i] >= strength_of(law, press.setup.powder.seed, grains.id[i], diameter))
      rows.push_back(i);
  }
  std::ranges::sort(rows, {}, [&](std::uint32_t row) { return grains.id[row]; });
  return rows;
}

} // namespace

double strength_of(BreakageLaw const& law, std::uint64_t seed, std::uint32_t id, double diameter) {
  // The first fragment has its grain's id and another strength.
  std::uint64_t const draw =
      mixed(mixed(mixed(seed) + id) ^ std::bit_cast<std::uint64_t>(diameter));
  double const survivors = (static_cast<double>(draw >> 11) + 1.0) * 0x1.0p-53; // in (0, 1]
  double const m = law.weibull_modulus;
  return law.strength * std::pow(diameter / law.reference_diameter, -3.0 / m) *
         std::pow(-std::log(survivors), 1.0 / m);
}

std::vector<double> largest_stress(dem::World const& world) {
  dem::Spheres const& grains = world.grains;
  std::vector<double> stress(grains.size(), 0.0);
  auto const raise = [&](std::uint32_t i, double force) {
    double const diameter = 2.0 * grains.radius[i];
    stress[i] = std::max(stress[i], force / (diameter * diameter));
  };
  dem::ContactStream(world).for_each([&](dem::Contact const& contact) {
    raise(contact.i, contact.normal_force);
    if (contact.j != dem::Contact::none)
      raise(contact.j, contact.normal_force);
  });
  return stress;
}

void break_grains(Press& press) {
  dem::complete_step(press.world);
  auto const rows = broken_rows(press);
  if (rows.empty())
    return;
  double const before = total_energy(press.world);
  dem::Dust const dust = dem::crush(press.world, rows, press.setup.powder.seed);
  PressTally& tally = press.tally;
  tally.breakage_loss += before - total_energy(press.world);
  tally.broken_grains += rows.size();
  tally.dust_mass += dust.mass;
  tally.dust_volume += dust.volume;
  tally.start_momentum -= dust.momentum.z();
  press.grain_mass -= dust.mass;
  tally.axial_force = axial_force_on_grains(press);
  press.programme.renew_plan(press.world);
}

} // namespace coupling
