#include "tests/crosscode/liggghts/bed.hpp"
#include "tests/crosscode/liggghts/child_process.hpp"
#include "tests/crosscode/liggghts/steps.hpp"
#include "tests/crosscode/liggghts/text_file.hpp"

#include "dem/step/advance.hpp"
#include "dem/step/world.hpp"
#include "dem/surface/tool_shapes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

/// Contacts that LIGGGHTS and our engine follow step by step: the same numbers, to rounding.
namespace crosscode {
namespace {

dem::World build_world(StepsDeck const& deck) {
  dem::World world;
  world.gravity.setZero();
  auto const mgo = world.materials.add({"MgO", 3500.0, 250e6, 0.25});
  auto const alumina = world.materials.add({"Al2O3", 3000.0, 250e6, 0.25});
  auto const wall = world.materials.add({"wall", 8000.0, 200e6, 0.29});
  dem::Interaction const grains{
      .restitution = 0.5, .static_friction = 0.2, .cohesion_energy_density = deck.cohesion};
  dem::Interaction const at_wall{.restitution = 0.5, .static_friction = 0.2};
  for (auto const i : {mgo, alumina}) {
    for (auto const j : {mgo, alumina})
      world.materials.set_interaction(i, j, grains);
    world.materials.set_interaction(i, wall, at_wall);
  }
  world.grains = dem::make_spheres(deck.grains, seed_components());
  world.contacts = dem::ContactEngine(
      {.friction_limit = deck.friction_limit == FrictionLimit::net ? "net" : "elastic",
       .precision = dem::Precision::full});
  if (deck.plate_speed) {
    dem::TriangleSurface const plate{
        .name = "plate",
        .vertices = {{-0.08, -0.04, 0.0}, {0.08, -0.04, 0.0}, {0.0, 0.08, 0.0}},
        .triangles = {{0, 1, 2}}};
    world.tools.push_back(
        {.name = "plate", .surface = dem::SmoothSurface(plate), .material = wall});
    world.tools.back().velocity = {0.0, 0.0, *deck.plate_speed};
  }
  if (deck.bore_diameter) {
    // Long enough that no rim is near; recognised as the cylinder that its vertices stand on.
    auto die =
        dem::make_die(*deck.bore_diameter, 4.0 * *deck.bore_diameter, *deck.bore_diameter, 1e-5);
    for (dem::Vec3& vertex : die.vertices)
      vertex.z() -= 2.0 * *deck.bore_diameter;
    world.tools.push_back({.name = "die", .surface = dem::SmoothSurface(die), .material = wall});
  }
  return world;
}

Frame frame_of(dem::World const& world) {
  Frame frame(world.grains.size());
  for (std::size_t row = 0; row < frame.size(); ++row)
    frame[world.grains.id[row]] = {world.grains.position[row], world.grains.velocity[row],
                                   world.grains.spin[row], world.grains.force[row],
                                   world.grains.torque[row]};
  return frame;
}

std::vector<Frame> follow_with_presscheck(StepsDeck const& deck) {
  dem::World world = build_world(deck);
  dem::prepare(world);
  std::vector<Frame> frames{frame_of(world)};
  for (long step = 0; step < deck.n_steps; ++step) {
    dem::advance(world, deck.dt);
    frames.push_back(frame_of(world));
  }
  return frames;
}

std::vector<Frame> follow_with_liggghts(StepsDeck const& deck, std::string const& name) {
  auto const folder = std::filesystem::path("steps") / name;
  write_steps_deck(deck, folder);
  auto const cost = run_program({find_program("liggghts", "liggghts"), "-in", "in.steps"}, folder);
  if (cost.exit_status != 0)
    throw std::runtime_error("liggghts failed:\n" + read_text(folder / "output.txt"));
  return read_steps(folder / "steps.txt", deck.grains.size());
}

/// The bar for a law against its equations; rounding alone gives 1e-13 here.
constexpr double tolerance = 1e-10;

void expect_same_steps(StepsDeck const& deck, std::string const& name) {
  auto const peer = follow_with_liggghts(deck, name);
  auto const ours = follow_with_presscheck(deck);
  ASSERT_EQ(peer.size(), static_cast<std::size_t>(deck.n_steps) + 1);
  // The grains must have met, or equality would say nothing.
  double largest_force = 0.0;
  for (Frame const& frame : peer)
    largest_force = std::max(largest_force, frame[0].force.norm());
  ASSERT_GT(largest_force, 1e-3);
  auto const deviations = largest_deviations(peer, ours);
  char const* const names[] = {"position", "velocity", "spin", "force", "torque"};
  for (std::size_t k = 0; k < deviations.size(); ++k) {
    EXPECT_LE(deviations[k], tolerance) << name << ": " << names[k];
    fmt::print("{}: {} deviates by {:.1e} of its largest value\n", name, names[k], deviations[k]);
  }
}

/// Two grains of unequal size, 1 um apart, that meet obliquely with spins.
dem::Packing oblique_pair() {
  return {{{0.0, 0.0, 0.0}, 3e-3, 0, {0.1, 0.0, 0.02}, {20.0, -35.0, 50.0}},
          {{1.4e-3, 0.8e-3, 0.682643e-3}, 0.5e-3, 1, {-0.15, 0.05, -0.08}, {-300.0, 150.0, 80.0}}};
}

TEST(StepsAgainstLiggghts, ObliquePairWithoutCohesion) {
  expect_same_steps({.grains = oblique_pair(), .cohesion = 0.0, .n_steps = 400}, "oblique");
}

TEST(StepsAgainstLiggghts, CohesivePairWithNetFrictionLimit) {
  expect_same_steps({.grains = oblique_pair()}, "cohesive_net");
}

TEST(StepsAgainstLiggghts, CohesivePairWithElasticFrictionLimit) {
  expect_same_steps({.grains = oblique_pair(), .friction_limit = FrictionLimit::elastic},
                    "cohesive_elastic");
}

TEST(StepsAgainstLiggghts, GrainSlidesOnAMovingPlate) {
  dem::Packing const grain{
      {{0.0, 0.0, 0.251e-3}, 0.5e-3, 0, {0.3, -0.1, -0.1}, {100.0, 200.0, -50.0}}};
  expect_same_steps({.grains = grain, .plate_speed = 0.2, .n_steps = 600}, "plate");
}

TEST(StepsAgainstLiggghts, GrainSlidesAlongTheBore) {
  // 5 um from the wall of a 22.05 mm bore, thrown outwards, sideways and along.
  dem::Vec3 const outwards(0.6, 0.8, 0.0);
  dem::Packing const grain{
      {(11.025e-3 - 0.505e-3) * outwards, 1e-3, 0, {0.3, -0.1, 0.15}, {100.0, 200.0, -50.0}}};
  expect_same_steps({.grains = grain, .bore_diameter = 22.05e-3, .n_steps = 3000}, "bore");
}

} // namespace
} // namespace crosscode
