#pragma once

#include "dem/spheres.hpp"
#include "dem/step/world.hpp"

#include <cstdint>
#include <vector>

namespace coupling {

/// Where grains and tools stood in the window whose punch force was largest: for the picture of the
/// stressed tools. Kept only beside deformable ones.
struct PeakState {
  double force = 0.0;              ///< [N]
  double time = 0.0;               ///< [s]
  std::vector<dem::Vec3> position; ///< [m], of the grains
  std::vector<double> radius;      ///< [m]
  std::vector<std::uint8_t> material;
  std::vector<dem::Vec3> tools; ///< [m], displacement of each tool

  void keep(dem::World const& world, double new_force) {
    force = new_force;
    time = world.time;
    position = world.grains.position;
    radius = world.grains.radius;
    material = world.grains.material;
    tools.clear();
    for (dem::Tool const& tool : world.tools)
      tools.push_back(tool.displacement);
  }

  template <class Field> void visit_state(Field&& field) {
    field("peak/force", force);
    field("peak/time", time);
    field("peak/position", position);
    field("peak/radius", radius);
    field("peak/material", material);
    field("peak/tools", tools);
  }
};

} // namespace coupling
