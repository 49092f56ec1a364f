#include "dem/contact/multi_contact.hpp"
#include "tests/support/near.hpp"
#include "tests/support/world_builders.hpp"

#include <gtest/gtest.h>

#include <cmath>

/// Contacts that know of each other against their formulas, multi_contact.hpp.
namespace {

using dem::Vec3;

constexpr double R = 0.5e-3, b = 0.8;

build::Recipe recipe(double coefficient = b) {
  build::Recipe r = coupling::verification::smooth();
  r.grain.poisson_ratio = 0.2;
  r.law.multi_contact = coefficient;
  return r;
}

/// b K / V,  K = E / (3 (1 - 2 nu)),  V = 4/3 pi R^3.
double per_volume(build::Recipe const& r, double radius) {
  double const K = r.grain.young_modulus / (3.0 * (1.0 - 2.0 * r.grain.poisson_ratio));
  return r.law.multi_contact * K / (4.0 / 3.0 * dem::pi * radius * radius * radius);
}

double hertz(build::Recipe const& r, dem::Material const& other, double radius, double overlap) {
  double const modulus = dem::mix(r.grain, other, {}).effective_modulus;
  return 4.0 / 3.0 * modulus * std::sqrt(radius) * std::pow(overlap, 1.5);
}

/// A grain in a box that is smaller than it, by twice an overlap in each direction.
dem::World boxed_grain(build::Recipe const& r, Vec3 const& overlap) {
  dem::World world = build::empty_world(r);
  world.grains.add(Vec3::Zero(), R, r.grain.density, 0);
  for (int axis = 0; axis < 3; ++axis)
    for (double const side : {-1.0, 1.0}) {
      Vec3 const out = side * Vec3::Unit(axis);
      build::add_plane(world, nullptr, (R - overlap[axis]) * out, -out, Vec3::Zero(), 10e-3);
    }
  dem::prepare(world);
  return world;
}

} // namespace

TEST(MultiContact, WallsFeelTheVolumeThatTheOthersDisplace) {
  auto const r = recipe();
  Vec3 const d(20e-6, 35e-6, 50e-6);
  auto const world = boxed_grain(r, d);
  auto const volume = [&](int axis) { return 0.5 * dem::pi * R * d[axis] * d[axis]; };
  for (std::size_t t = 0; t < 6; ++t) {
    int const axis = static_cast<int>(t / 2);
    double others = -volume(axis);
    for (int k = 0; k < 3; ++k)
      others += 2.0 * volume(k);
    double const force =
        hertz(r, r.wall, R, d[axis]) + dem::pi * R * d[axis] * per_volume(r, R) * others;
    EXPECT_TRUE(near::relative(world.tools[t].force.norm(), force, 1e-12)) << t;
  }
}

TEST(MultiContact, EachOfTwoGrainsAddsItsOwnOthers) {
  // Four in a row, of different sizes: the middle contact feels both outer ones.
  auto const r = recipe();
  double const radius[] = {0.4e-3, 0.5e-3, 0.7e-3, 0.3e-3}, d[] = {20e-6, 30e-6, 15e-6};
  dem::World world = build::empty_world(r);
  double x = 0.0;
  for (int k = 0; k < 4; ++k) {
    world.grains.add(Vec3(x, 0, 0), radius[k], r.grain.density, 0);
    if (k < 3)
      x += radius[k] + radius[k + 1] - d[k];
  }
  dem::prepare(world);
  double effective[3], volume[3], force[3];
  for (int c = 0; c < 3; ++c) {
    effective[c] = radius[c] * radius[c + 1] / (radius[c] + radius[c + 1]);
    volume[c] = 0.5 * dem::pi * effective[c] * d[c] * d[c];
  }
  for (int c = 0; c < 3; ++c) {
    double pressure = 0.0;
    if (c > 0)
      pressure += per_volume(r, radius[c]) * volume[c - 1];
    if (c < 2)
      pressure += per_volume(r, radius[c + 1]) * volume[c + 1];
    force[c] = hertz(r, r.grain, effective[c], d[c]) + dem::pi * effective[c] * d[c] * pressure;
  }
  auto const push = [&](std::uint32_t id) {
    return world.grains.force[build::row_of(world, id)].x();
  };
  EXPECT_TRUE(near::relative(push(0), -force[0], 1e-12));
  EXPECT_TRUE(near::relative(push(1), force[0] - force[1], 1e-11));
  EXPECT_TRUE(near::relative(push(2), force[1] - force[2], 1e-11));
  EXPECT_TRUE(near::relative(push(3), force[2], 1e-12));
  // What measures see is what the sweep did.
  for (dem::Contact const& contact : dem::list_contacts(world)) {
    auto const c = std::min(world.grains.id[contact.i], world.grains.id[contact.j]);
    EXPECT_TRUE(near::relative(contact.normal_force, force[c], 1e-12));
  }
}

TEST(MultiContact, LeavesALoneContactAlone) {
  auto const force = [](double coefficient) {
    auto const r = recipe(coefficient);
    dem::World world = build::empty_world(r);
    world.grains.add(Vec3::Zero(), R, r.grain.density, 0);
    world.grains.add(Vec3(1.9 * R, 0, 0), R, r.grain.density, 0);
    dem::prepare(world);
    return world.grains.force[build::row_of(world, 0)].x();
  };
  EXPECT_TRUE(near::relative(force(10.0), force(0.0), 1e-14));
}

/// U(d) of a boxed grain by its definition, and its slope against the walls' forces.
TEST(MultiContact, ItsEnergyIsTheForcesPotential) {
  auto const r = recipe();
  Vec3 const d(20e-6, 35e-6, 50e-6);
  auto const energy = [&](Vec3 const& overlap) {
    auto const world = boxed_grain(r, overlap);
    return world.contacts.energy(world).elastic;
  };
  auto const world = boxed_grain(r, d);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 const h = 1e-9 * Vec3::Unit(axis);
    double const slope = (energy(d + h) - energy(d - h)) / 2e-9; // of two walls
    EXPECT_TRUE(near::relative(slope, 2.0 * world.tools[2 * axis].force.norm(), 1e-7)) << axis;
  }
}

TEST(MultiContact, ShortensTheStableStep) {
  auto const step = [](double coefficient) {
    return dem::stable_time_step(boxed_grain(recipe(coefficient), Vec3::Constant(50e-6)));
  };
  // Of one wall, with x = d/R = 0.1:  F' = 2 E* sqrt(R d)  against
  // pi R b K / V (5/2 pi R d^2 + 5 pi R d^2); two walls each way, grain free.
  auto const r = recipe(1.0);
  double const d = 50e-6, area = dem::pi * R * d;
  double const law = 2.0 * dem::mix(r.grain, r.wall, {}).effective_modulus * std::sqrt(R * d);
  double const crowd = per_volume(r, R) * (dem::pi * R * 2.5 * area * d + 5.0 * area * area);
  EXPECT_TRUE(near::relative(step(0.0) / step(1.0), std::sqrt((law + crowd) / law), 1e-6));
}
