#include "coupling/verification/benchmarks.hpp"
#include "coupling/verification/closed_forms.hpp"
#include "coupling/verification/setups.hpp"

#include <cmath>

namespace coupling::verification {
namespace {

/// A grain squeezed by linear springs between two plates: an undamped oscillator of frequency w =
/// sqrt(2 k/m).
struct Oscillator {
  dem::World world;
  double frequency; ///< w [rad/s]
  double amplitude; ///< [m], of the start, at rest
};

Oscillator squeezed_grain() {
  Recipe recipe = smooth();
  recipe.law.normal = "hooke";
  double const R = 1e-3, overlap = 1e-5, amplitude = 1e-7;
  dem::World world = empty_world(recipe);
  world.grains.add(dem::Vec3(0, 0, amplitude), R, recipe.grain.density, 0);
  add_tool(world, "below", plate(20.0 * R, 5.0 * R), dem::Vec3(0, 0, -R + overlap));
  add_tool(world, "above", ceiling(20.0 * R, 5.0 * R), dem::Vec3(0, 0, R - overlap));
  double const m = sphere_mass(recipe.grain.density, R);
  double const E = effective_modulus(recipe.grain.young_modulus, recipe.grain.poisson_ratio,
                                     recipe.wall.young_modulus, recipe.wall.poisson_ratio);
  double const k = hooke_stiffness(E, R, m, recipe.law.characteristic_velocity);
  dem::prepare(world);
  return {std::move(world), std::sqrt(2.0 * k / m), amplitude};
}

/// Error of the position after a period and an eighth in n steps, over the amplitude. At an eighth
/// the position changes with the phase, so the error of the frequency shows at first order.
double phase_error(int n) {
  Oscillator oscillator = squeezed_grain();
  double const phase = 2.25 * pi;
  double const dt = phase / oscillator.frequency / n;
  for (int k = 0; k < n; ++k)
    dem::advance(oscillator.world, dt);
  return oscillator.world.grains.position[0].z() / oscillator.amplitude - std::cos(phase);
}

std::vector<Benchmark> order() {
  double const coarse = phase_error(100), fine = phase_error(200);
  // Velocity Verlet turns by asin(w dt/2) where the oscillator turns by w dt/2: phase 2 n
  // asin(phase/(2n)).
  double const phase = 2.25 * pi;
  double const expected = std::cos(200.0 * std::asin(phase / 200.0)) - std::cos(phase);
  return {compare("integrator/order", 2.0, std::log2(coarse / fine), 1e-2,
                  "Hairer, Lubich and Wanner, Acta Numerica 12 (2003) 399"),
          compare("integrator/phase_error", expected, coarse, 1e-6,
                  "dispersion of the leapfrog: sin(w' dt/2) = w dt/2")};
}

/// Largest excursion over the amplitude in 300 steps at a multiple of the critical step 2/w.
double excursion(double share) {
  Oscillator oscillator = squeezed_grain();
  double const dt = share * 2.0 / oscillator.frequency;
  double largest = 0.0;
  for (int k = 0; k < 300 && largest < 1e3; ++k) {
    dem::advance(oscillator.world, dt);
    largest =
        std::max(largest, std::abs(oscillator.world.grains.position[0].z()) / oscillator.amplitude);
  }
  return largest;
}

std::vector<Benchmark> stability() {
  Oscillator const oscillator = squeezed_grain();
  double const critical = 2.0 / oscillator.frequency;
  // Below the limit the excursion stays at the start's 1; above, it grows by 1.33 a step until the
  // grain leaves.
  bool const grows = excursion(1.01) > 30.0;
  double const estimate = dem::stable_time_step(oscillator.world) / critical;
  return {compare("stability/excursion_just_below", 1.0, excursion(0.99), 1e-3,
                  "leapfrog: stable for w dt < 2"),
          compare("stability/grows_just_above", 1.0, grows ? 1.0 : 0.0, 0.0,
                  "leapfrog: unstable for w dt > 2"),
          // Plates do not move, so the grain's row of the stiffness matrix is w^2 = sum k/m itself.
          compare("stability/step_estimate", 1.0, estimate, 1e-6,
                  "Gershgorin's bound, exact between fixed plates")};
}

std::vector<Benchmark> free_fall() {
  Recipe recipe;
  recipe.gravity = dem::Vec3(0.3, -0.2, -9.81);
  recipe.law.precision = dem::Precision::full;
  dem::World world = empty_world(recipe);
  dem::Vec3 const v(0.1, 0.2, 0.5);
  world.grains.add(dem::Vec3::Zero(), 1e-3, 3500.0, 0, v, dem::Vec3(1, 2, 3));
  dem::prepare(world);
  double const dt = 1e-4;
  int const n = 1000;
  for (int k = 0; k < n; ++k)
    dem::advance(world, dt);
  double const t = n * dt;
  dem::Vec3 const exact = v * t + 0.5 * t * t * recipe.gravity;
  char const* const source = "Galilei: v t + g t^2/2, exact for velocity Verlet";
  return {compare("free_fall/position", exact.z(), world.grains.position[0].z(), 1e-12, source),
          compare("free_fall/sideways", exact.x(), world.grains.position[0].x(), 1e-12, source),
          compare("free_fall/spin_kept", 3.0, world.grains.spin[0].z(), 1e-15, "no torque")};
}

} // namespace

std::vector<Experiment> integrator_experiments() {
  return {{"integrator", order}, {"stability", stability}, {"free_fall", free_fall}};
}

} // namespace coupling::verification
