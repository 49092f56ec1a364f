#pragma once

#include "coupling/verification/closed_forms.hpp"
#include "coupling/verification/setups.hpp"

#include <algorithm>
#include <stdexcept>

namespace coupling::verification {

/// A grain that falls along -z on a plate at rest, or on a second grain centred below it.
struct ImpactSetup {
  Recipe recipe;
  double radius = 1e-3;           ///< [m]
  double other_radius = 0.0;      ///< [m]; 0: a plate instead of a grain
  double other_mass_factor = 1.0; ///< the other grain's mass is this times what its material gives
  dem::Vec3 velocity = -dem::Vec3::UnitZ(); ///< [m/s]
  dem::Vec3 spin = dem::Vec3::Zero();       ///< [rad/s]
  dem::Vec3 other_velocity = dem::Vec3::Zero();
  dem::Vec3 other_spin = dem::Vec3::Zero();
  double gap = 0.0;       ///< [m], at the start; 0: a thousandth of the expected overlap
  double time_step = 0.0; ///< [s]; 0: duration / steps
  int steps = 4000;       ///< of the expected duration

  HertzImpact expected() const {
    auto const& [grain, wall] = std::pair(recipe.grain, recipe.wall);
    bool const on_plate = other_radius == 0.0;
    dem::Material const& partner = on_plate ? wall : grain;
    double const mass = sphere_mass(grain.density, radius);
    double const other =
        on_plate ? 0.0 : other_mass_factor * sphere_mass(grain.density, other_radius);
    return {.effective_modulus = effective_modulus(grain.young_modulus, grain.poisson_ratio,
                                                   partner.young_modulus, partner.poisson_ratio),
            .effective_radius = on_plate ? radius : reduced(radius, other_radius),
            .effective_mass = on_plate ? mass : reduced(mass, other),
            .speed = other_velocity.z() - velocity.z()};
  }
};

struct ImpactResult {
  dem::Vec3 velocity, spin; ///< of the grain, after
  dem::Vec3 other_velocity; ///< of the other grain, after
  double separation_speed;  ///< [m/s], > 0
  double max_overlap;       ///< [m]
  double max_force;         ///< [N]
  double duration;          ///< [s], touch and parting interpolated between steps
};

/// Steps until the grains have met and parted.
inline ImpactResult collide(ImpactSetup const& setup) {
  HertzImpact const expected = setup.expected();
  bool const on_plate = setup.other_radius == 0.0;
  double const gap = setup.gap > 0.0 ? setup.gap : 1e-3 * expected.max_overlap();
  double const dt = setup.time_step > 0.0 ? setup.time_step : expected.duration() / setup.steps;
  double const density = setup.recipe.grain.density;

  dem::World world = empty_world(setup.recipe);
  world.grains.add(dem::Vec3(0, 0, setup.radius + gap), setup.radius, density, 0, setup.velocity,
                   setup.spin);
  if (on_plate) {
    add_tool(world, "plate", plate(50.0 * setup.radius, 10.0 * setup.radius));
  } else {
    world.grains.add(dem::Vec3(0, 0, -setup.other_radius), setup.other_radius,
                     density * setup.other_mass_factor, 0, setup.other_velocity, setup.other_spin);
  }
  dem::prepare(world);

  auto const overlap = [&] {
    dem::Spheres const& grains = world.grains;
    if (on_plate)
      return setup.radius - grains.position[0].z();
    return grains.radius[0] + grains.radius[1] - (grains.position[0] - grains.position[1]).norm();
  };
  ImpactResult result{};
  double before = overlap(), touched = -1.0, time = 0.0;
  int const limit =
      static_cast<int>((20.0 * expected.duration() + 10.0 * gap / expected.speed) / dt) + 10;
  for (int k = 0; k < limit; ++k) {
    dem::advance(world, dt);
    time += dt;
    double const now = overlap();
    result.max_overlap = std::max(result.max_overlap, now);
    result.max_force = std::max(result.max_force, world.grains.force[0].norm());
    double const crossing = time - dt * now / (now - before);
    if (before <= 0.0 && now > 0.0)
      touched = crossing;
    if (before > 0.0 && now <= 0.0) {
      std::size_t const i = row_of(world, 0);
      result.velocity = world.grains.velocity[i];
      result.spin = world.grains.spin[i];
      if (!on_plate)
        result.other_velocity = world.grains.velocity[row_of(world, 1)];
      result.separation_speed = result.velocity.z() - result.other_velocity.z();
      result.duration = crossing - touched;
      return result;
    }
    before = now;
  }
  throw std::runtime_error("the grains did not part");
}

} // namespace coupling::verification
