#pragma once

#include "coupling/press_programme.hpp"
#include "coupling/verification/setups.hpp"

#include <any>
#include <cmath>
#include <map>
#include <string>

/// A press whose bed is a formula instead of grains: what the programme needs of a World, and no
/// more.
namespace stand_in {

inline constexpr double fill_height = 20e-3; // [m]
inline constexpr double bed_height = 10e-3;  // [m], of the unloaded bed
inline constexpr double stiffness = 1e6;     // [N/m]
inline constexpr double longest_step = 3e-7; // [s]

/// A spring of `bed_height`, which may have crept; it only pushes.
struct Bed {
  double creep = 0.0; ///< [m]

  double force(double gap) const { return std::max(stiffness * (bed_height - creep - gap), 0.0); }
};

/// Grains give the bed its mass, about the seed's: the servo reads it.
inline dem::World press_world() {
  dem::World world = coupling::verification::empty_world({});
  for (std::string const name : {"die", "upper_punch", "lower_punch"})
    coupling::verification::add_tool(world, name, coupling::verification::plate(1e-3, 1e-3));
  for (int k = 0; k < 185; ++k)
    world.grains.add(dem::Vec3(0.0, 0.0, 1e-3 * k), 1.5e-3, 3500.0, 0);
  return world;
}

inline coupling::PressProgramme programme(std::vector<coupling::Stage> stages,
                                          bool adaptive = false) {
  return {std::move(stages),
          {.lower = 0.0, .upper = fill_height},
          [](dem::World const&) { return longest_step; },
          adaptive};
}

/// What advance() does to tools and time; the bed answers at the new gap.
inline void advance(dem::World& world, coupling::PressProgramme const& programme, Bed const& bed,
                    double dt) {
  for (dem::Tool& tool : world.tools)
    tool.displacement += dt * tool.velocity;
  double const force = bed.force(punch_gap(world, programme.faces()));
  for (dem::Tool& tool : world.tools) {
    double const sign = tool.name == "upper_punch" ? 1.0 : tool.name == "lower_punch" ? -1.0 : 0.0;
    tool.force = tool.present ? dem::Vec3(0.0, 0.0, sign * force) : dem::Vec3::Zero();
  }
  world.time += dt;
  ++world.step;
}

inline void one_step(dem::World& world, coupling::PressProgramme& programme, Bed const& bed = {}) {
  double const dt = programme.command_step(world);
  advance(world, programme, bed, dt);
  programme.step_done(world);
}

/// Runs the present stage to its end.
inline void run_stage(dem::World& world, coupling::PressProgramme& programme, Bed const& bed = {}) {
  programme.start_stage(world);
  while (!programme.stage_has_ended(world))
    one_step(world, programme, bed);
  programme.finish_stage(world);
}

inline coupling::Stage press_to_gap(double gap) {
  return {.name = "loading",
          .kind = coupling::StageKind::move,
          .tools = {"upper_punch"},
          .speed = -0.2,
          .until = coupling::Limit::gap,
          .gap = gap};
}

inline coupling::Stage press_to_force(double force) {
  return {.name = "loading",
          .kind = coupling::StageKind::move,
          .tools = {"upper_punch"},
          .speed = -0.2,
          .until = coupling::Limit::force,
          .force = force};
}

inline coupling::Stage keep_force(double force, double duration) {
  return {.name = "dwell",
          .kind = coupling::StageKind::hold,
          .tools = {"upper_punch"},
          .duration = duration,
          .force = force,
          .servo = true};
}

/// Keeps a state in memory: the shape of StateWriter and StateReader.
struct Memory {
  std::map<std::string, std::any> fields;

  auto writer() {
    return [this](std::string const& name, auto const& value) { fields[name] = value; };
  }
  auto reader() {
    return [this]<class T>(std::string const& name, T& value) {
      value = std::any_cast<T>(fields.at(name));
    };
  }
};

} // namespace stand_in
