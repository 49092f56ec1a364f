#include "tests/support/world_builders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

/// Elasto-plastic contacts led along a path of loading, unloading and reloading, against their
/// published branches written out one by one. The grains are so heavy that nothing slows them.
namespace {

using dem::Vec3;

struct Pair {
  double radius, modulus; ///< R* [m], E* [Pa]
};

struct Reading {
  double overlap, most, force; ///< [m], [m], [N]
};

build::Recipe plastic_recipe(std::string const& normal) {
  build::Recipe r;
  r.grain.density = 1e13; // [kg/m^3]
  r.grain.young_modulus = 2e9;
  r.grain_grain = {.restitution = 1.0, .static_friction = 0.0, .surface_energy = 0.0};
  r.law.normal = normal;
  r.law.cohesion = "none";
  r.law.tangential = "frictionless";
  r.law.precision = dem::Precision::full;
  r.law.yield_pressure = 40e6;
  r.law.plasticity_ratio = 0.6;
  r.gravity = Vec3::Zero();
  return r;
}

constexpr double small = 0.25e-3, large = 0.75e-3; // [m], radii

Pair pair_of(build::Recipe const& r) {
  double const nu = r.grain.poisson_ratio;
  return {small * large / (small + large), r.grain.young_modulus / (2.0 * (1.0 - nu * nu))};
}

/// Leads the pair through the overlaps `turns` [m], one after the other, and reads overlap and
/// force after every step.
std::vector<Reading> lead(build::Recipe const& recipe, std::vector<double> const& turns) {
  dem::World world = build::empty_world(recipe);
  world.grains.add(Vec3(0, 0, small + 1e-9), small, recipe.grain.density, 0);
  world.grains.add(Vec3(0, 0, -large), large, recipe.grain.density, 0);
  dem::prepare(world);
  std::vector<Reading> path;
  double most = 0.0;
  for (double const turn : turns) {
    auto const overlap = [&] {
      return small + large - (world.grains.position[0] - world.grains.position[1]).norm();
    };
    double const way = turn > overlap() ? 1.0 : -1.0;
    std::size_t const upper = build::row_of(world, 0), lower = build::row_of(world, 1);
    world.grains.velocity[upper] = Vec3(0, 0, -way * 0.01);
    world.grains.velocity[lower] = Vec3::Zero();
    while (way * (turn - overlap()) > 0.0) {
      dem::advance(world, 5e-6);
      most = std::max(most, overlap());
      path.push_back({overlap(), most, world.grains.force[build::row_of(world, 0)].z()});
    }
  }
  return path;
}

std::vector<double> const there_and_back{20e-6, 14e-6, 18e-6, 30e-6, -1e-6};

void expect_law(std::vector<Reading> const& path, std::function<double(Reading const&)> const& law,
                double tolerance) {
  double largest = 0.0, error = 0.0;
  for (Reading const& at : path) {
    largest = std::max(largest, std::abs(at.force));
    error = std::max(error, std::abs(at.force - law(at)));
  }
  EXPECT_GT(largest, 0.0);
  EXPECT_LE(error, tolerance * largest);
}

/// Thornton and Ning (1998), branch by branch.
double thornton_ning(Reading const& at, Pair const& p, double yield_pressure) {
  double const pi = std::acos(-1.0), d = at.overlap, E = p.modulus, R = p.radius;
  if (d <= 0.0)
    return 0.0;
  double const d_y = std::pow(pi * yield_pressure / (2.0 * E), 2) * R;
  double const F_y = std::pow(pi * yield_pressure, 3) * R * R / (6.0 * E * E);
  auto const loading = [&](double x) {
    return x <= d_y ? 4.0 / 3.0 * E * std::sqrt(R) * std::pow(x, 1.5)
                    : F_y + pi * yield_pressure * R * (x - d_y);
  };
  if (d >= at.most)
    return loading(d);
  if (at.most <= d_y)
    return loading(d);
  double const F_m = loading(at.most);
  double const R_p =
      4.0 * E / (3.0 * F_m) * std::pow((2.0 * F_m + F_y) / (2.0 * pi * yield_pressure), 1.5);
  double const d_p = at.most - std::pow(3.0 * F_m / (4.0 * E * std::sqrt(R_p)), 2.0 / 3.0);
  return d > d_p ? 4.0 / 3.0 * E * std::sqrt(R_p) * std::pow(d - d_p, 1.5) : 0.0;
}

/// Thakur et al. (2014), branch by branch, n = 3/2 and f_0 = 0.
double edinburgh(Reading const& at, Pair const& p, double lambda, double w, double chi) {
  double const pi = std::acos(-1.0), n = 1.5;
  if (at.overlap <= 0.0)
    return 0.0;
  double const k1 = 4.0 / 3.0 * p.modulus * std::sqrt(p.radius), k2 = k1 / (1.0 - lambda);
  double const d_p = std::pow(lambda, 1.0 / n) * at.most;
  double F_min = 1.5 * pi * w * std::sqrt(p.radius * at.most);
  F_min = std::min(F_min, 0.5 * k2 * std::pow(d_p, n));
  double const d_min = std::pow(std::pow(d_p, n) - F_min / k2, 1.0 / n);
  double const k_adh = F_min / std::pow(d_min, chi);
  double const first = k1 * std::pow(at.overlap, n);
  double const second = k2 * (std::pow(at.overlap, n) - std::pow(d_p, n));
  double const third = -k_adh * std::pow(at.overlap, chi);
  if (second >= first)
    return first;
  return at.overlap > d_min ? second : third;
}

TEST(ThorntonNingContact, FollowsItsBranches) {
  build::Recipe const r = plastic_recipe("thornton_ning");
  auto const path = lead(r, there_and_back);
  expect_law(
      path, [&](Reading const& at) { return thornton_ning(at, pair_of(r), 40e6); }, 1e-10);
  build::Recipe single = r;
  single.law.precision = dem::Precision::mixed;
  expect_law(
      lead(single, there_and_back),
      [&](Reading const& at) { return thornton_ning(at, pair_of(r), 40e6); }, 2e-5);
}

TEST(ThorntonNingContact, BelowYieldIsHertz) {
  build::Recipe strong = plastic_recipe("thornton_ning"), hertz = plastic_recipe("hertz");
  strong.law.yield_pressure = 1e12;
  auto const a = lead(strong, there_and_back), b = lead(hertz, there_and_back);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
    EXPECT_NEAR(a[k].force, b[k].force, 1e-11 * std::abs(b[k].force)) << k;
}

TEST(ThorntonNingContact, CohesionFollowsTheContactArea) {
  build::Recipe r = plastic_recipe("thornton_ning");
  r.law.cohesion = "linear_hertz_circle";
  r.grain_grain.cohesion_energy_density = 3e6;
  Pair const p = pair_of(r);
  auto const law = [&](Reading const& at) {
    if (at.overlap <= 0.0)
      return 0.0;
    // The contact's radius from its own Hertz law, F = 4 E* a^3 / (3 R_p), from a_m at d_m on.
    double const force = thornton_ning(at, p, 40e6);
    double const F_m = thornton_ning({at.most, at.most, 0.0}, p, 40e6);
    double const a = std::sqrt(p.radius * at.most) * std::cbrt(force / F_m);
    return force - 3e6 * std::acos(-1.0) * a * a;
  };
  expect_law(lead(r, there_and_back), law, 1e-9);
}

TEST(EdinburghContact, FollowsItsBranches) {
  for (double const chi : {1.5, 5.0})
    for (double const w : {0.0, 2.0, 200.0}) {
      build::Recipe r = plastic_recipe("edinburgh");
      r.law.adhesion_exponent = chi;
      r.grain_grain.surface_energy = w;
      auto const law = [&](Reading const& at) { return edinburgh(at, pair_of(r), 0.6, w, chi); };
      expect_law(lead(r, there_and_back), law, 1e-9);
      r.law.precision = dem::Precision::mixed;
      expect_law(lead(r, there_and_back), law, 5e-5);
    }
}

TEST(EdinburghContact, WithoutPlasticityIsHertz) {
  build::Recipe elastic = plastic_recipe("edinburgh"), hertz = plastic_recipe("hertz");
  elastic.law.plasticity_ratio = 0.0;
  elastic.grain_grain.surface_energy = 2.0; // has nothing to act on
  auto const a = lead(elastic, there_and_back), b = lead(hertz, there_and_back);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
    EXPECT_NEAR(a[k].force, b[k].force, 1e-11 * std::abs(b[k].force)) << k;
}

/// Friction is limited by the force measured from the adhesive branch: a pair held at zero force
/// slides against friction.
TEST(EdinburghContact, GripsAtZeroForce) {
  build::Recipe r = plastic_recipe("edinburgh");
  r.law.tangential = "mindlin";
  r.law.tangential_damping = false;
  r.grain_grain.static_friction = 0.3;
  r.grain_grain.surface_energy = 2.0;
  double const most = 20e-6;
  double const zero = most * std::pow(0.6, 2.0 / 3.0); // d_p
  dem::World world = build::empty_world(r);
  world.grains.add(Vec3(0, 0, small + 1e-9), small, r.grain.density, 0);
  world.grains.add(Vec3(0, 0, -large), large, r.grain.density, 0);
  dem::prepare(world);
  auto const go = [&](double to, double speed) {
    auto const overlap = [&] {
      return small + large - (world.grains.position[0] - world.grains.position[1]).norm();
    };
    world.grains.velocity[build::row_of(world, 0)] = Vec3(0, 0, -speed);
    while ((to - overlap()) * speed > 0.0)
      dem::advance(world, 1e-7);
  };
  go(most, 0.01);
  go(zero, -0.01);
  world.grains.velocity[build::row_of(world, 0)] = Vec3(0.01, 0, 0);
  for (int k = 0; k < 100; ++k)
    dem::advance(world, 1e-7);
  double const pull = 1.5 * std::acos(-1.0) * 2.0 * std::sqrt(pair_of(r).radius * most);
  Vec3 const force = world.grains.force[build::row_of(world, 0)];
  EXPECT_LT(force.z(), 0.0); // it hangs by its adhesion
  EXPECT_NEAR(force.x(), -0.3 * (force.z() + pull), 1e-3 * pull);
}

/// F = K d^(3/2) + A 3/2 K sqrt(d) d': Brilliantov et al. (1996), eq. 10.
TEST(ViscousContact, AddsTheRateOfTheElasticForce) {
  for (std::string const normal : {"hertz", "thornton_ning", "edinburgh"}) {
    build::Recipe r = plastic_recipe(normal), viscous = r;
    viscous.law.viscous_time = 3e-5;
    std::vector<double> const way{20e-6, 17e-6};
    auto const bare = lead(r, way), slow = lead(viscous, way);
    ASSERT_EQ(bare.size(), slow.size());
    double error = 0.0, largest = 0.0;
    for (std::size_t k = 1; k + 1 < bare.size(); ++k) {
      double const rate = (bare[k + 1].force - bare[k - 1].force) / 1e-5; // [N/s], over two steps
      bool const is_smooth = (bare[k + 1].most > bare[k].most) == (bare[k].most > bare[k - 1].most);
      // A plastic contact is as stiff as it unloads, also while it loads.
      if (!is_smooth || (normal != "hertz" && bare[k].overlap >= bare[k].most))
        continue;
      error = std::max(error, std::abs(slow[k].force - bare[k].force - 3e-5 * rate));
      largest = std::max(largest, 3e-5 * std::abs(rate));
    }
    EXPECT_GT(largest, 0.0) << normal;
    EXPECT_LE(error, 1e-3 * largest) << normal;
  }
}

} // namespace
