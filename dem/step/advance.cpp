#include "dem/step/advance.hpp"

#include "dem/expect.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace dem {

namespace {

void move_tools(World& world, double dt) {
  for (Tool& tool : world.tools) {
    tool.displacement += dt * tool.velocity;
    if (tool.deformation)
      tool.yielded += dt * tool.deformation->speed();
  }
  world.window_time += dt;
}

/// A lost number spreads through every contact: look for it in the sum of all positions.
void refuse_lost_numbers(World const& world) {
  for (std::size_t i = 0; i < world.grains.size(); ++i)
    if (!world.grains.position[i].allFinite())
      throw PhysicsGuard(
          "grain " + std::to_string(world.grains.id[i]) + " has no position any more at time " +
          std::to_string(world.time) +
          " s (a force or velocity left the range of numbers). Is the time step too large?");
}

} // namespace

void prepare(World& world) {
  world.contacts.evaluate(world);
}

void advance(World& world, double dt) {
  advance_ahead(world, dt);
  complete_step(world);
}

void complete_step(World& world) {
  world.contacts.complete(world);
}

void advance_ahead(World& world, double dt) {
  EXPECT(dt > 0.0);
  double const gravity_power = world.contacts.kick_and_drift(world, dt);
  world.energy.gravity_work += dt * gravity_power; // exact: m g . dx
  if (!std::isfinite(gravity_power))
    refuse_lost_numbers(world);
  move_tools(world, dt);
  world.contacts.refresh(world, dt);
  world.contacts.sweep(world, dt);
  world.time += dt;
  ++world.step;
}

double rayleigh_time(World const& world) {
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < world.grains.size(); ++i) {
    Material const& m = world.materials[world.grains.material[i]];
    double const shear_modulus = m.young_modulus / (2.0 * (1.0 + m.poisson_ratio));
    double const time = pi * world.grains.radius[i] * std::sqrt(m.density / shear_modulus) /
                        (0.1631 * m.poisson_ratio + 0.8766);
    shortest = std::min(shortest, time);
  }
  return shortest;
}

double stable_time_step(World const& world) {
  return world.contacts.stable_step(world);
}

} // namespace dem
