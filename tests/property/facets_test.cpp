#include "tests/support/near.hpp"
#include "tests/support/world_builders.hpp"

#include <gtest/gtest.h>

#include <cmath>

/// The force on a grain does not know how a flat is cut into triangles.
namespace {

using dem::Vec3;

build::Recipe recipe() {
  build::Recipe r;
  r.grain_wall = {.restitution = 0.6, .static_friction = 0.3, .cohesion_energy_density = 1e6};
  r.law.precision = dem::Precision::full;
  return r;
}

dem::World grain_over(int n_cells, bool crossed, Vec3 const& position, Vec3 const& velocity,
                      Vec3 const& spin) {
  dem::World world = build::empty_world(recipe());
  world.grains.add(position, 0.5e-3, 3500.0, 0, velocity, spin);
  build::add_tool(world, "punch", build::plate(6e-3, 3e-3, n_cells, crossed));
  dem::prepare(world);
  return world;
}

TEST(Facets, DoNotChangeTheForceAtRest) {
  double const z = 0.48e-3;
  dem::World const whole =
      grain_over(1, false, Vec3(0.3e-3, 0.7e-3, z), Vec3::Zero(), Vec3::Zero());
  double const expected = whole.grains.force[0].norm();
  ASSERT_GT(expected, 0.0);
  for (int const n : {2, 5, 12, 40}) {
    for (bool const crossed : {false, true}) {
      double const cell = 12e-3 / n;
      // Over a face, an edge, a diagonal and a vertex of the pattern.
      for (Vec3 const& at : {Vec3(0.3 * cell, 0.1 * cell, z), Vec3(0.5 * cell, 0, z),
                             Vec3(0.5 * cell, 0.5 * cell, z), Vec3(0, 0, z)}) {
        SCOPED_TRACE(testing::Message()
                     << n << (crossed ? " crossed" : "") << " at " << at.transpose());
        dem::World const world = grain_over(n, crossed, at, Vec3::Zero(), Vec3::Zero());
        EXPECT_TRUE(near::relative(world.grains.force[0].z(), expected, 1e-13));
        EXPECT_LE(world.grains.force[0].head<2>().norm(), 1e-13 * expected);
        EXPECT_EQ(dem::list_contacts(world).size(), 1u);
      }
    }
  }
}

TEST(Facets, DoNotShakeAGrainThatSlidesAndRollsOverTheirEdges) {
  Vec3 const start(-3.1e-3, -2.3e-3, 0.495e-3), velocity(1.0, 0.7, -0.02), spin(-800, 1500, 300);
  dem::World whole = grain_over(1, false, start, velocity, spin);
  dem::World fine = grain_over(30, true, start, velocity, spin);
  near::LargestDeviation F("force"), T("torque"), x("position"), tool("tool force");
  for (int k = 0; k < 4000; ++k) {
    dem::advance(whole, 1e-6);
    dem::advance(fine, 1e-6);
    F.add(fine.grains.force[0], whole.grains.force[0]);
    T.add(fine.grains.torque[0], whole.grains.torque[0]);
    x.add(fine.grains.position[0], whole.grains.position[0]);
    tool.add(fine.tools[0].force, whole.tools[0].force);
  }
  EXPECT_GT((whole.grains.position[0] - start).norm(), 2e-3)
      << "it must cross several cells of 0.4 mm";
  EXPECT_TRUE(F.within(1e-11));
  EXPECT_TRUE(T.within(1e-11));
  EXPECT_TRUE(x.within(1e-11));
  EXPECT_TRUE(tool.within(1e-11));
}

TEST(Facets, OfTheRimPushOnceAndOutwards) {
  // Half over the edge of the punch: the closest point is on the rim, the force points from there
  // to the centre.
  dem::World const world =
      grain_over(3, false, Vec3(6e-3 + 0.2e-3, 0, 0.4e-3), Vec3::Zero(), Vec3::Zero());
  auto const contacts = dem::list_contacts(world);
  ASSERT_EQ(contacts.size(), 1u);
  Vec3 const outwards = Vec3(0.2, 0, 0.4).normalized();
  EXPECT_LE((contacts[0].normal - outwards).norm(), 1e-12);
  EXPECT_TRUE(near::relative(contacts[0].overlap, 0.5e-3 - std::hypot(0.2e-3, 0.4e-3), 1e-12));
}

} // namespace
