#include "tests/support/near.hpp"
#include "tests/support/world_builders.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

/// The energy book:  kinetic + stored in normal contacts + lost in dashpots + put into tangential
/// springs, dashpots and sliding + lost in rolling = start + work of gravity + work of tools, up to
/// the step's own error.
namespace {

using dem::Vec3;

double kinetic_energy(dem::World const& world) {
  double sum = 0.0;
  dem::Spheres const& g = world.grains;
  for (std::size_t i = 0; i < g.size(); ++i) {
    sum += 0.5 * g.mass[i] * g.velocity[i].squaredNorm() +
           0.5 * dem::sphere_inertia(g.mass[i], g.radius[i]) * g.spin[i].squaredNorm();
  }
  return sum;
}

struct Book {
  double change;  ///< of kinetic and stored energy [J]
  double spent;   ///< dashpots, tangential, rolling [J]
  double work;    ///< of gravity and tools [J]
  double scale;   ///< [J], energy that moved
  double plastic; ///< [J], of what was spent
};

/// @param dt  [s], steps = 1.2e-4 s / dt
Book keep_book(std::string const& normal, bool rolling, double dt, double multi_contact = 0.0) {
  build::Recipe r;
  r.grain_grain = {
      .restitution = 0.5,
      .static_friction = 0.3,
      .rolling_friction = 0.05,
      // Cohesion's slope must stay below the spring's, and linear springs are soft here.
      .cohesion_energy_density = normal == "hooke" ? 1e5 : 3e6,
      .surface_energy = 0.5};
  r.law.yield_pressure = 15e6;  // of thornton_ning; the impacts reach it, cohesion does not
  r.law.plasticity_ratio = 0.7; // of edinburgh
  r.grain_wall = {
      .restitution = 0.7, .static_friction = 0.2, .rolling_friction = 0.05, .surface_energy = 0.2};
  r.law.normal = normal;
  r.law.cohesion = normal == "jkr" || normal == "edinburgh" ? "none" : "sjkr2";
  r.law.tangential = normal == "hooke" ? "hooke_spring" : "mindlin";
  r.law.rolling = rolling ? "constant_torque" : "none";
  r.law.precision = dem::Precision::full;
  r.law.multi_contact = multi_contact;
  r.gravity = Vec3(0, 20.0, -50.0); // strong, so that its share of the book is seen
  dem::World world = build::empty_world(r);
  double const side = 4e-3;
  build::add_cloud(world, {.n_grains = 150,
                           .smallest = 0.25e-3,
                           .largest = 0.6e-3,
                           .high = Vec3::Constant(side),
                           .relative_overlap = 0.0,
                           .speed = 0.5,
                           .spin = 500.0});
  build::add_plane(world, nullptr, Vec3(side / 2, side / 2, 0), Vec3::UnitZ(), Vec3(0.2, 0, 1.0),
                   5 * side);
  build::add_plane(world, nullptr, Vec3(side / 2, side / 2, side), -Vec3::UnitZ(),
                   Vec3(0, -0.3, -1.0), 5 * side);
  dem::prepare(world);
  auto const held = [&] {
    dem::StoredEnergy const stored = world.contacts.energy(world);
    return kinetic_energy(world) + stored.elastic + stored.cohesive;
  };
  double const start = held();
  int const steps = static_cast<int>(std::lround(6e-4 / dt));
  for (int k = 0; k < steps; ++k)
    dem::advance(world, dt);
  double tools = 0.0;
  for (dem::Tool const& tool : world.tools)
    tools += tool.work;
  dem::EnergyTally const& tally = world.energy;
  EXPECT_GT(tally.normal_damping, 0.0);
  EXPECT_GT(tally.tangential_work, 0.0);
  EXPECT_GT(tools, 0.0);
  if (rolling) {
    EXPECT_GT(tally.rolling_work, 0.0);
  }
  return {.change = held() - start,
          .spent = tally.normal_damping + tally.plastic_work + tally.tangential_work +
                   tally.rolling_work,
          .work = tally.gravity_work + tools,
          .scale = std::abs(tools) + tally.normal_damping + tally.tangential_work,
          .plastic = tally.plastic_work};
}

double gap(Book const& book) {
  return (book.change + book.spent - book.work) / book.scale;
}

TEST(EnergyBook, ClosesForHertzWithCohesionAndRolling) {
  EXPECT_LE(std::abs(gap(keep_book("hertz", true, 5e-8))), 1e-3);
}

TEST(EnergyBook, ClosesForHertz) {
  EXPECT_LE(std::abs(gap(keep_book("hertz", false, 5e-8))), 1e-3);
}

TEST(EnergyBook, ClosesForHooke) {
  EXPECT_LE(std::abs(gap(keep_book("hooke", false, 5e-8))), 1e-3);
}

TEST(EnergyBook, ClosesForJkr) {
  EXPECT_LE(std::abs(gap(keep_book("jkr", false, 5e-8))), 2e-3);
}

TEST(EnergyBook, ClosesForPlasticContacts) {
  for (std::string const normal : {"thornton_ning", "edinburgh"}) {
    Book const book = keep_book(normal, false, 5e-8);
    EXPECT_LE(std::abs(gap(book)), 1e-3) << normal;
    EXPECT_GT(book.plastic, 0.02 * book.scale) << normal << ": enough to be missed";
  }
  EXPECT_EQ(keep_book("hertz", false, 4e-7).plastic, 0.0);
}

TEST(EnergyBook, ClosesForContactsThatKnowOfEachOther) {
  EXPECT_LE(std::abs(gap(keep_book("hertz", false, 5e-8, 10.0))), 1e-3);
  EXPECT_LE(std::abs(gap(keep_book("thornton_ning", false, 5e-8, 10.0))), 1e-3);
}

TEST(EnergyBook, ClosesBetterWithASmallerStep) {
  // Touch and stick-slip fall between steps: at least first order.
  double const coarse = std::abs(gap(keep_book("hertz", false, 4e-7)));
  double const fine = std::abs(gap(keep_book("hertz", false, 5e-8)));
  EXPECT_LT(coarse, 2e-2);
  EXPECT_LT(fine, 0.5 * coarse);
}

TEST(EnergyBook, OfASlidingGrainIsItsFrictionalWork) {
  // A grain slides on a plate at its resting overlap: mu m g times the slipped path goes into the
  // tangential account, and the path of the contact point exceeds the grain's because it also spins
  // up: while it slides it slips v0 t - 7/4 mu g t^2.
  build::Recipe r;
  r.law.cohesion = "none";
  r.law.tangential_damping =
      false; // it starts in contact: the law does not clip the dashpot of an unstretched spring
  r.law.precision = dem::Precision::full;
  r.grain_wall = {.restitution = 0.5, .static_friction = 0.25};
  r.gravity = Vec3(0, 0, -9.81);
  dem::World world = build::empty_world(r);
  double const R = 0.5e-3, v0 = 0.2, mu = 0.25, g = 9.81;
  oracle::Law const law = build::law_of(r.law, r.grain, r.wall, r.grain_wall);
  double const Estar = static_cast<double>(1 / ((1 - law.i.poisson * law.i.poisson) / law.i.young +
                                                (1 - law.j.poisson * law.j.poisson) / law.j.young));
  double const mass = r.grain.density * dem::sphere_volume(R);
  double const overlap = std::pow(mass * g / (4.0 / 3.0 * Estar * std::sqrt(R)), 2.0 / 3.0);
  world.grains.add(Vec3(0, 0, R - overlap), R, r.grain.density, 0, Vec3(v0, 0, 0));
  build::add_plane(world, nullptr, Vec3::Zero(), Vec3::UnitZ(), Vec3::Zero(), 50e-3);
  dem::prepare(world);
  double const dt = 1e-6;
  int const steps = 15000;
  for (int k = 0; k < steps; ++k)
    dem::advance(world, dt);
  double const t = steps * dt;
  EXPECT_GT(v0 - 3.5 * mu * g * t, 0.0) << "it must still slide";
  double const slipped = v0 * t - 1.75 * mu * g * t * t;
  EXPECT_TRUE(near::relative(world.energy.tangential_work, mu * mass * g * slipped, 2e-3));
}

} // namespace
