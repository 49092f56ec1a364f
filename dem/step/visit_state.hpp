#pragma once

#include "dem/contact/contact_state.hpp"
#include "dem/step/world.hpp"

#include <cstdint>
#include <vector>

namespace dem {

/// Everything that a restart must keep of a World, as plain arrays. What a case file rebuilds
/// (materials, tool surfaces, laws) is not part of it.
struct WorldState {
  Spheres grains;
  ContactState contacts;
  std::vector<Vec3> tool_displacement, tool_velocity, tool_force; ///< n_tools
  std::vector<double> tool_radial_force, tool_work;               ///< n_tools
  std::vector<std::uint8_t> tool_present;                         ///< n_tools
  EnergyTally energy;
  double time = 0.0;
  std::uint64_t step = 0;
};

/// A copy of the world's state.
WorldState capture_state(World const& world);

/// Puts a state back into a world of the same case; it goes on to the same bits.
/// @throws InvalidInput if the state has other numbers of grains or tools than it says
void restore_state(World& world, WorldState const& state);

/// Calls `field(name, value)` for every part of the state, in a fixed order. `value` is a reference
/// to a std::vector of Vec3, double, std::uint8_t or std::uint32_t, or to one double or
/// std::uint64_t. Used for writing and reading.
template <class State, class Field> void visit_state(State& state, Field&& field) {
  field("grains/position", state.grains.position);
  field("grains/velocity", state.grains.velocity);
  field("grains/spin", state.grains.spin);
  field("grains/force", state.grains.force);
  field("grains/torque", state.grains.torque);
  field("grains/radius", state.grains.radius);
  field("grains/mass", state.grains.mass);
  field("grains/material", state.grains.material);
  field("grains/id", state.grains.id);
  field("contacts/outer_position", state.contacts.outer_position);
  field("contacts/inner_position", state.contacts.inner_position);
  field("contacts/outer_skin", state.contacts.outer_skin);
  field("contacts/inner_skin", state.contacts.inner_skin);
  field("contacts/outer_tool", state.contacts.outer_tool);
  field("contacts/inner_tool", state.contacts.inner_tool);
  field("contacts/outer_tool_skin", state.contacts.outer_tool_skin);
  field("contacts/inner_tool_skin", state.contacts.inner_tool_skin);
  field("contacts/spring", state.contacts.spring);
  field("contacts/normal_memory", state.contacts.normal_memory);
  field("contacts/outer_builds", state.contacts.outer_builds);
  field("contacts/inner_builds", state.contacts.inner_builds);
  field("tools/displacement", state.tool_displacement);
  field("tools/velocity", state.tool_velocity);
  field("tools/force", state.tool_force);
  field("tools/radial_force", state.tool_radial_force);
  field("tools/work", state.tool_work);
  field("tools/present", state.tool_present);
  field("energy/normal_damping", state.energy.normal_damping);
  field("energy/tangential_work", state.energy.tangential_work);
  field("energy/rolling_work", state.energy.rolling_work);
  field("energy/gravity_work", state.energy.gravity_work);
  field("time", state.time);
  field("step", state.step);
}

} // namespace dem
