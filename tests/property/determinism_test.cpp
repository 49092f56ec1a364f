#include "tests/support/world_builders.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <functional>
#include <map>
#include <ostream>
#include <string>
#include <type_traits>

/// The same input gives the same bits: on any number of threads, from a copy, and across a restart.
namespace {

using dem::Vec3;

struct Flavour {
  std::string name;
  std::string normal;
  dem::Precision precision;
  double multi_contact = 0.0;

  friend std::ostream& operator<<(std::ostream& out, Flavour const& f) { return out << f.name; }
};

build::Recipe recipe(Flavour const& flavour) {
  build::Recipe r;
  r.grain_grain = {.restitution = 0.5,
                   .static_friction = 0.3,
                   .rolling_friction = 0.02,
                   .cohesion_energy_density = 2e6,
                   .surface_energy = 0.5};
  r.grain_wall = {.restitution = 0.6, .static_friction = 0.2, .surface_energy = 0.2};
  r.law.normal = flavour.normal;
  r.law.cohesion = flavour.normal == "jkr" ? "none" : "sjkr2";
  r.law.rolling = "constant_torque";
  r.law.precision = flavour.precision;
  r.law.multi_contact = flavour.multi_contact;
  r.gravity = Vec3(0, 0, -9.81);
  return r;
}

constexpr double dt = 4e-7;

/// A crowded bed between two closing plates, with a fast grain: lists are rebuilt at uneven times.
dem::World pressed_bed(Flavour const& flavour) {
  dem::World world = build::empty_world(recipe(flavour));
  double const side = 7e-3;
  build::add_cloud(world, {.n_grains = 1200,
                           .smallest = 0.15e-3,
                           .largest = 0.9e-3,
                           .high = Vec3::Constant(side),
                           .relative_overlap = 0.05,
                           .speed = 1.0});
  build::add_plane(world, nullptr, Vec3(side / 2, side / 2, 0), Vec3::UnitZ(), Vec3(0, 0, 0.3),
                   5 * side, 3);
  build::add_plane(world, nullptr, Vec3(side / 2, side / 2, side), -Vec3::UnitZ(), Vec3(0, 0, -0.3),
                   5 * side);
  return world;
}

void advance(dem::World& world, int steps) {
  for (int k = 0; k < steps; ++k)
    dem::advance(world, dt);
}

/// Bytes of everything a restart would keep, by name.
std::map<std::string, std::string> bytes_of(dem::World const& world) {
  std::map<std::string, std::string> bytes;
  dem::WorldState state = dem::capture_state(world);
  dem::visit_state(state, [&](std::string const& name, auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_arithmetic_v<Value>) {
      bytes[name].assign(reinterpret_cast<char const*>(&value), sizeof value);
    } else if (!value.empty()) {
      bytes[name].assign(reinterpret_cast<char const*>(value.data()),
                         value.size() * sizeof value[0]);
    }
  });
  return bytes;
}

void expect_same_bits(dem::World const& a, dem::World const& b) {
  auto const left = bytes_of(a), right = bytes_of(b);
  ASSERT_EQ(left.size(), right.size());
  for (auto const& [name, bytes] : left) {
    ASSERT_TRUE(right.contains(name)) << name;
    EXPECT_TRUE(bytes == right.at(name)) << name << " differs";
  }
}

class Bits : public ::testing::TestWithParam<Flavour> {
protected:
  void SetUp() override { threads_ = omp_get_max_threads(); }
  void TearDown() override { omp_set_num_threads(threads_); }

private:
  int threads_ = 1;
};

TEST_P(Bits, AreTheSameOnOneTwoAndFourThreads) {
  omp_set_num_threads(1);
  dem::World one = pressed_bed(GetParam());
  dem::prepare(one);
  advance(one, 150);
  for (int const threads : {2, 4}) {
    SCOPED_TRACE(threads);
    omp_set_num_threads(threads);
    dem::World many = pressed_bed(GetParam());
    dem::prepare(many);
    advance(many, 150);
    expect_same_bits(one, many);
  }
}

TEST_P(Bits, AreTheSameAfterARestart) {
  dem::World through = pressed_bed(GetParam());
  dem::prepare(through);
  advance(through, 77);
  dem::WorldState const saved = dem::capture_state(through);
  advance(through, 123);

  // A restart reads the case anew, and may run on another machine with more threads.
  omp_set_num_threads(2);
  dem::World resumed = pressed_bed(GetParam());
  dem::restore_state(resumed, saved);
  advance(resumed, 123);
  expect_same_bits(through, resumed);
}

TEST_P(Bits, AreTheSameInACopy) {
  dem::World original = pressed_bed(GetParam());
  dem::prepare(original);
  advance(original, 50);
  dem::World copy = original;
  advance(original, 60);
  advance(copy, 60);
  expect_same_bits(original, copy);
}

TEST_P(Bits, AreNotDisturbedByLooking) {
  dem::World watched = pressed_bed(GetParam()), alone = pressed_bed(GetParam());
  dem::prepare(watched);
  dem::prepare(alone);
  for (int k = 0; k < 60; ++k) {
    advance(watched, 1);
    advance(alone, 1);
    if (k % 7 == 0) {
      EXPECT_FALSE(dem::list_contacts(watched).empty());
      EXPECT_GT(dem::stable_time_step(watched), 0.0);
    }
  }
  expect_same_bits(watched, alone);
}

INSTANTIATE_TEST_SUITE_P(Flavours, Bits,
                         ::testing::Values(Flavour{"hertz_mixed", "hertz", dem::Precision::mixed},
                                           Flavour{"hertz_full", "hertz", dem::Precision::full},
                                           Flavour{"crowded", "hertz", dem::Precision::mixed, 1.0},
                                           Flavour{"jkr_mixed", "jkr", dem::Precision::mixed}),
                         [](auto const& p) { return p.param.name; });

} // namespace
