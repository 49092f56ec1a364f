#include "tests/support/near.hpp"
#include "tests/support/world_builders.hpp"

#include <gtest/gtest.h>

/// The engine's neighbour lists against all pairs: the oracle tries every pair at every step.
namespace {

using dem::Vec3;

build::Recipe recipe() {
  build::Recipe r;
  r.grain_grain = {.restitution = 0.5, .static_friction = 0.3, .cohesion_energy_density = 1e6};
  r.grain_wall = {.restitution = 0.7, .static_friction = 0.2};
  r.law.precision = dem::Precision::full;
  r.gravity = Vec3(0.5, -1.0, -9.81);
  return r;
}

struct Comparison {
  near::LargestDeviation x{"position"}, v{"velocity"}, w{"spin"}, F{"force"}, T{"torque"};

  void add(dem::World const& world, oracle::System const& system) {
    for (std::size_t row = 0; row < world.grains.size(); ++row) {
      oracle::Body const& body = system.bodies[world.grains.id[row]];
      x.add(world.grains.position[row], body.x.cast<double>());
      v.add(world.grains.velocity[row], body.v.cast<double>());
      w.add(world.grains.spin[row], body.w.cast<double>());
      F.add(world.grains.force[row], body.F.cast<double>());
      T.add(world.grains.torque[row], body.T.cast<double>());
    }
  }

  void expect_within(double tolerance) const {
    EXPECT_GT(F.largest(), 0.0);
    EXPECT_TRUE(x.within(tolerance));
    EXPECT_TRUE(v.within(tolerance));
    EXPECT_TRUE(w.within(tolerance));
    EXPECT_TRUE(F.within(tolerance));
    EXPECT_TRUE(T.within(tolerance));
  }
};

class SizeRatio : public ::testing::TestWithParam<double> {};

// A bed whose largest grain is 1, 6, 20, 40 times the smallest: every force at rest in one
// evaluation, no motion.
TEST_P(SizeRatio, ForcesEqualThoseOfAllPairs) {
  dem::World world = build::empty_world(recipe());
  double const small = 0.1e-3;
  build::add_cloud(world, {.n_grains = 1200,
                           .smallest = small,
                           .largest = GetParam() * small,
                           .high = Vec3::Constant((3.0 + 1.5 * GetParam()) * 1e-3 * 0.4),
                           .relative_overlap = 0.2});
  oracle::System system = build::mirror(world, recipe());
  dem::prepare(world);
  system.gather(0);
  EXPECT_GT(system.n_contacts(), 50);
  Comparison comparison;
  comparison.add(world, system);
  comparison.expect_within(1e-11);
}
INSTANTIATE_TEST_SUITE_P(Bed, SizeRatio, ::testing::Values(1.0, 6.0, 20.0, 40.0));

// Grains fly through several list lifetimes in a closed box: a contact found late, lost early, or
// with its history dropped at a rebuild shows as a force error of order one.
TEST(NeighbourLists, FindEveryContactOfAnAgitatedBox) {
  dem::World world = build::empty_world(recipe());
  double const side = 4e-3;
  build::add_cloud(world, {.n_grains = 150,
                           .smallest = 0.1e-3,
                           .largest = 0.8e-3,
                           .high = Vec3::Constant(side),
                           .relative_overlap = 0.0,
                           .speed = 3.0});
  oracle::System system = build::mirror(world, recipe());
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 const normal = Vec3::Unit(axis);
    build::add_plane(world, &system, Vec3::Constant(0.5 * side) - 0.5 * side * normal, normal,
                     Vec3::Zero(), 3 * side);
    build::add_plane(world, &system, Vec3::Constant(0.5 * side) + 0.5 * side * normal, -normal,
                     -0.5 * normal, 3 * side, 2);
  }
  dem::prepare(world);
  system.gather(0);
  Comparison comparison;
  int met = 0;
  for (int k = 0; k < 600; ++k) {
    dem::advance(world, 2e-7);
    system.step(2e-7);
    comparison.add(world, system);
    met = std::max(met, system.n_contacts());
  }
  EXPECT_GT(met, 20);
  // Collisions multiply rounding; a lost contact would be 1e-1, not 1e-8.
  comparison.expect_within(1e-8);
}

TEST(NeighbourLists, FollowOneFastGrainThroughARestingBed) {
  build::Recipe r = recipe();
  r.gravity.setZero();
  dem::World world = build::empty_world(r);
  build::add_cloud(world, {.n_grains = 200,
                           .smallest = 0.2e-3,
                           .largest = 0.4e-3,
                           .high = Vec3::Constant(5e-3),
                           .relative_overlap = 0.0,
                           .speed = 0.0,
                           .spin = 0.0});
  double const R = 0.15e-3;
  world.grains.add(Vec3(-1e-3, 2.4e-3, 2.6e-3), R, r.grain.density, 0, Vec3(40, 0.5, -0.3),
                   Vec3(0, 4e4, 0));
  oracle::System system = build::mirror(world, r);
  dem::prepare(world);
  system.gather(0);
  Comparison comparison;
  for (int k = 0; k < 800; ++k) {
    dem::advance(world, 1e-7);
    system.step(1e-7);
    comparison.add(world, system);
  }
  comparison.expect_within(1e-8);
}

// Four hundred grains pressed by two moving plates: the law with all its switches, in a crowd.
TEST(ManyGrains, FollowTheOracleWhilePressed) {
  build::Recipe r = recipe();
  r.law.rolling = "constant_torque";
  r.grain_grain.rolling_friction = 0.03;
  r.grain_wall.rolling_friction = 0.03;
  r.grain_wall.cohesion_energy_density = 5e5;
  dem::World world = build::empty_world(r);
  double const side = 4e-3;
  build::add_cloud(world, {.n_grains = 400,
                           .smallest = 0.15e-3,
                           .largest = 0.6e-3,
                           .high = Vec3::Constant(side),
                           .relative_overlap = 0.05});
  oracle::System system = build::mirror(world, r);
  build::add_plane(world, &system, Vec3(side / 2, side / 2, 0), Vec3::UnitZ(), Vec3(0.1, 0, 0.5),
                   5 * side, 3);
  build::add_plane(world, &system, Vec3(side / 2, side / 2, side), -Vec3::UnitZ(),
                   Vec3(0, -0.1, -0.5), 5 * side);
  dem::prepare(world);
  system.gather(0);
  Comparison comparison;
  near::LargestDeviation tools("tool force");
  for (int k = 0; k < 400; ++k) {
    dem::advance(world, 2e-7);
    system.step(2e-7);
    comparison.add(world, system);
    for (std::size_t t = 0; t < 2; ++t)
      tools.add(world.tools[t].force, system.planes[t].F.cast<double>());
  }
  comparison.expect_within(1e-9);
  EXPECT_TRUE(tools.within(1e-9));
}

} // namespace
