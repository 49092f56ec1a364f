#pragma once

#include "dem/step/world.hpp"

#include <string>

namespace dem {

/// Calls `field(name, value)` for everything that a restart must restore, in a fixed order. `value` is a reference
/// to a std::vector of Vec3, double, float, std::uint8_t, std::uint32_t or std::uint64_t, or to one double or
/// std::uint64_t. What a case file rebuilds (materials, tool surfaces, laws) is not visited.
template <class Field>
void visit_state(World& world, Field&& field) {
  Spheres& grains = world.grains;
  field("grains/position", grains.position);
  field("grains/velocity", grains.velocity);
  field("grains/spin", grains.spin);
  field("grains/force", grains.force);
  field("grains/torque", grains.torque);
  field("grains/radius", grains.radius);
  field("grains/mass", grains.mass);
  field("grains/material", grains.material);
  field("grains/id", grains.id);
  field("time", world.time);
  field("step", world.step);
  field("energy/normal_damping", world.energy.normal_damping);
  field("energy/tangential_work", world.energy.tangential_work);
  field("energy/rolling_work", world.energy.rolling_work);
  field("energy/gravity_work", world.energy.gravity_work);
}

}  // namespace dem
