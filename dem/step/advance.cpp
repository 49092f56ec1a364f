#include "dem/step/advance.hpp"

#include "dem/expect.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace dem {

namespace {

void half_kick_and_drift(World& world, double dt) {
  Spheres& g = world.grains;
  std::size_t const n = g.size();
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i) {
    g.velocity[i] += (0.5 * dt / g.mass[i]) * g.force[i];
    g.spin[i] += (0.5 * dt / sphere_inertia(g.mass[i], g.radius[i])) * g.torque[i];
    g.position[i] += dt * g.velocity[i];
  }
}

void second_half_kick(World& world, double dt) {
  Spheres& g = world.grains;
  std::size_t const n = g.size();
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i) {
    g.velocity[i] += (0.5 * dt / g.mass[i]) * g.force[i];
    g.spin[i] += (0.5 * dt / sphere_inertia(g.mass[i], g.radius[i])) * g.torque[i];
  }
}

void move_tools(std::vector<Tool>& tools, double dt) {
  for (Tool& tool : tools) tool.displacement += dt * tool.velocity;
}

/// Work of gravity over the drift: it is exact, m g . dx. Summed in chunks of fixed size, so that the sum does not
/// depend on the number of threads.
double gravity_power(World const& world) {
  constexpr std::size_t chunk = 2048;
  Spheres const& g = world.grains;
  std::vector<double> part((g.size() + chunk - 1) / chunk, 0.0);
#pragma omp parallel for schedule(static)
  for (std::size_t p = 0; p < part.size(); ++p)
    for (std::size_t i = p * chunk; i < std::min(g.size(), (p + 1) * chunk); ++i)
      part[p] += g.mass[i] * world.gravity.dot(g.velocity[i]);
  double power = 0.0;
  for (double p : part) power += p;
  return power;
}

/// A lost number spreads through every contact: look for it in the sum of all positions.
void refuse_lost_numbers(World const& world) {
  for (std::size_t i = 0; i < world.grains.size(); ++i)
    if (!world.grains.position[i].allFinite())
      throw PhysicsGuard("grain " + std::to_string(world.grains.id[i]) + " has no position any more at time " +
                         std::to_string(world.time) +
                         " s (a force or velocity left the range of numbers). Is the time step too large?");
}

}  // namespace

void prepare(World& world) {
  world.contacts.refresh(world, 1e-7);
  world.contacts.compute(world, 0.0);
}

void advance(World& world, double dt) {
  EXPECT(dt > 0.0);
  half_kick_and_drift(world, dt);
  double const power = gravity_power(world);
  world.energy.gravity_work += dt * power;
  if (!std::isfinite(power)) refuse_lost_numbers(world);
  move_tools(world.tools, dt);
  world.contacts.refresh(world, dt);
  world.contacts.compute(world, dt);
  second_half_kick(world, dt);
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

double stable_time_step(World const& world) { return world.contacts.stable_step(world); }

}  // namespace dem
