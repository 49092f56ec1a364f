#include "tests/support/near.hpp"
#include "tests/support/world_builders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

/// Symmetries that every pair law must have, on a crowded cloud of unequal cohesive grains with
/// spins.
namespace {

using dem::Vec3;

build::Recipe recipe() {
  build::Recipe r;
  r.grain_grain = {.restitution = 0.5,
                   .static_friction = 0.4,
                   .rolling_friction = 0.02,
                   .cohesion_energy_density = 2e6};
  r.grain_wall = r.grain_grain;
  r.law.rolling = "constant_torque";
  r.law.precision = dem::Precision::full;
  return r;
}

dem::World cloud() {
  dem::World world = build::empty_world(recipe());
  build::add_cloud(world, {.n_grains = 200,
                           .smallest = 0.15e-3,
                           .largest = 0.6e-3,
                           .high = Vec3::Constant(3.5e-3),
                           .speed = 0.5,
                           .seed = 7});
  return world;
}

void run(dem::World& world, int steps = 200, double dt = 2e-7) {
  dem::prepare(world);
  for (int k = 0; k < steps; ++k)
    dem::advance(world, dt);
}

/// Compares every grain of `b`, put through `image`, with the same grain of `a`.
template <class Image>
void expect_same(dem::World const& a, dem::World const& b, Image const& image, double tolerance) {
  near::LargestDeviation x("position"), v("velocity"), w("spin"), F("force"), T("torque");
  for (std::uint32_t id = 0; id < a.grains.size(); ++id) {
    std::size_t const i = build::row_of(a, id), j = build::row_of(b, id);
    x.add(image.point(b.grains.position[j]), a.grains.position[i]);
    v.add(image.velocity(b.grains.velocity[j]), a.grains.velocity[i]);
    w.add(image.axial(b.grains.spin[j]), a.grains.spin[i]);
    F.add(image.polar(b.grains.force[j]), a.grains.force[i]);
    T.add(image.axial(b.grains.torque[j]), a.grains.torque[i]);
  }
  EXPECT_GT(F.largest(), 0.0);
  EXPECT_TRUE(x.within(tolerance));
  EXPECT_TRUE(v.within(tolerance));
  EXPECT_TRUE(w.within(tolerance));
  EXPECT_TRUE(F.within(tolerance));
  EXPECT_TRUE(T.within(tolerance));
}

struct Identity {
  Vec3 point(Vec3 const& p) const { return p; }
  Vec3 velocity(Vec3 const& u) const { return u; }
  Vec3 polar(Vec3 const& u) const { return u; }
  Vec3 axial(Vec3 const& u) const { return u; }
};

struct Orthogonal {
  Eigen::Matrix3d matrix;
  Vec3 point(Vec3 const& p) const { return matrix * p; }
  Vec3 velocity(Vec3 const& u) const { return matrix * u; }
  Vec3 polar(Vec3 const& u) const { return matrix * u; }
  Vec3 axial(Vec3 const& u) const { return matrix.determinant() * (matrix * u); }
  Orthogonal inverse() const { return {matrix.transpose()}; }
};

void transform(dem::World& world, Orthogonal const& map) {
  for (Vec3& x : world.grains.position)
    x = map.point(x);
  for (Vec3& v : world.grains.velocity)
    v = map.polar(v);
  for (Vec3& w : world.grains.spin)
    w = map.axial(w);
}

// Rounding of 1e-16 grows with the collisions of a dissipative cloud; 200 steps amplify it by some
// thousands.
constexpr double rounding = 1e-10;

TEST(Momentum, IsKeptByInternalForces) {
  dem::World world = cloud();
  auto const momentum = [&] {
    Vec3 sum = Vec3::Zero();
    double scale = 0.0;
    for (std::size_t i = 0; i < world.grains.size(); ++i) {
      sum += world.grains.mass[i] * world.grains.velocity[i];
      scale += world.grains.mass[i] * world.grains.velocity[i].norm();
    }
    return std::pair(sum, scale);
  };
  auto const [before, scale] = momentum();
  run(world);
  EXPECT_LE((momentum().first - before).norm(), 1e-13 * scale);
  Vec3 total = Vec3::Zero();
  double largest = 0.0;
  for (Vec3 const& F : world.grains.force) {
    total += F;
    largest = std::max(largest, F.norm());
  }
  EXPECT_GT(largest, 0.0);
  EXPECT_LE(total.norm(), 1e-13 * largest * static_cast<double>(world.grains.size()));
}

TEST(AngularMomentum, ChangesOnlyByTheLeverConvention) {
  // Levers Ri - d/2 and Rj - d/2 sum to the distance of the centres: x_i - x_j = (c_i + c_j) n, so
  // the torques and the couple of the forces cancel exactly, pair by pair.
  dem::World world = cloud();
  dem::prepare(world);
  for (int k = 0; k < 50; ++k)
    dem::advance(world, 2e-7);
  Vec3 couple = Vec3::Zero();
  double scale = 0.0;
  for (std::size_t i = 0; i < world.grains.size(); ++i) {
    couple += world.grains.position[i].cross(world.grains.force[i]) + world.grains.torque[i];
    scale += world.grains.torque[i].norm();
  }
  EXPECT_GT(scale, 0.0);
  EXPECT_LE(couple.norm(), 1e-10 * scale);
}

TEST(Invariance, UnderAMovingFrame) {
  dem::World rest = cloud(), moving = cloud();
  Vec3 const drift(1.5, -0.7, 0.9); // [m/s], several times the grains' own speeds
  for (Vec3& v : moving.grains.velocity)
    v += drift;
  run(rest);
  run(moving);
  struct {
    Vec3 shift, drift;
    Vec3 point(Vec3 const& p) const { return p - shift; }
    Vec3 velocity(Vec3 const& u) const { return u - drift; }
    Vec3 polar(Vec3 const& u) const { return u; }
    Vec3 axial(Vec3 const& u) const { return u; }
  } const back{moving.time * drift, drift};
  expect_same(rest, moving, back, rounding);
}

TEST(Invariance, UnderRotation) {
  dem::World a = cloud(), b = cloud();
  Orthogonal const turn{Eigen::AngleAxisd(1.1, Vec3(1, 2, -2).normalized()).toRotationMatrix()};
  transform(b, turn);
  run(a);
  run(b);
  expect_same(a, b, turn.inverse(), rounding);
}

TEST(Invariance, UnderReflection) {
  dem::World a = cloud(), b = cloud();
  Vec3 const m = Vec3(2, -1, 2) / 3;
  Orthogonal const flip{Eigen::Matrix3d::Identity() - 2.0 * m * m.transpose()};
  transform(b, flip);
  run(a);
  run(b);
  expect_same(a, b, flip.inverse(), rounding);
}

TEST(Invariance, UnderTheOrderOfTheGrains) {
  dem::World a = cloud(), b = cloud();
  std::vector<std::size_t> order(b.grains.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937_64(3));
  dem::Spheres const original = b.grains;
  for (std::size_t k = 0; k < order.size(); ++k) {
    b.grains.position[k] = original.position[order[k]];
    b.grains.velocity[k] = original.velocity[order[k]];
    b.grains.spin[k] = original.spin[order[k]];
    b.grains.radius[k] = original.radius[order[k]];
    b.grains.mass[k] = original.mass[order[k]];
    b.grains.material[k] = original.material[order[k]];
    b.grains.id[k] = original.id[order[k]];
  }
  run(a);
  run(b);
  expect_same(a, b, Identity{}, rounding);
}

TEST(Invariance, OfARotatedPress) {
  // Tools turn with the grains: forces on grains near a plate must not know the axes.
  Orthogonal const turn{Eigen::AngleAxisd(0.7, Vec3(2, -1, 2).normalized()).toRotationMatrix()};
  dem::World a = cloud(), b = cloud();
  transform(b, turn);
  Vec3 const drive(0.05, 0.02, 2.0);
  build::add_plane(a, nullptr, Vec3(0, 0, 0.1e-3), Vec3::UnitZ(), drive, 20e-3);
  build::add_plane(b, nullptr, turn.point(Vec3(0, 0, 0.1e-3)), turn.polar(Vec3::UnitZ()),
                   turn.polar(drive), 20e-3);
  run(a);
  run(b);
  expect_same(a, b, turn.inverse(), rounding);
  EXPECT_GT(a.tools[0].force.norm(), 0.0);
  EXPECT_LE((turn.inverse().polar(b.tools[0].force) - a.tools[0].force).norm(),
            rounding * a.tools[0].force.norm());
}

} // namespace
