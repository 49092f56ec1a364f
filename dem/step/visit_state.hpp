#pragma once

#include "dem/contact/contact_state.hpp"
#include "dem/expect.hpp"
#include "dem/step/world.hpp"

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace dem {

/// Everything that a restart must keep of a World, as plain arrays. What a case file rebuilds
/// (materials, tool surfaces, laws) is not part of it.
struct WorldState {
  Spheres grains;
  ContactState contacts;
  std::vector<Vec3> tool_displacement, tool_velocity, tool_force; ///< n_tools
  std::vector<double> tool_radial_force, tool_work;               ///< n_tools
  std::vector<double> tool_yielded, tool_yield_work;              ///< n_tools
  std::vector<std::uint8_t> tool_present;                         ///< n_tools
  EnergyTally energy;
  double time = 0.0;
  double window_time = 0.0;
  std::uint64_t step = 0;
};

/// A copy of the world's state.
WorldState capture_state(World const& world);

/// Puts a state back into a world of the same case; it goes on to the same bits.
/// @throws InvalidInput if the state has other numbers of grains or tools than it says
void restore_state(World& world, WorldState const& state);

/// Places as two flat arrays: faces, and xi and eta in the first two components.
template <class Records, class Field>
void visit_places(std::string const& at, Records& records, Field&& field) {
  std::vector<std::uint32_t> face;
  std::vector<Vec3> on_face;
  for (auto const& record : records) {
    face.push_back(record.place.face);
    on_face.emplace_back(record.place.xi, record.place.eta, 0.0);
  }
  field(at + "face", face);
  field(at + "on_face", on_face);
  VALIDATE(face.size() == on_face.size(),
           "restart: the places on its tools do not fit together. Is the file damaged?");
  records.resize(face.size());
  for (std::size_t k = 0; k < face.size(); ++k)
    records[k].place = {face[k], on_face[k].x(), on_face[k].y()};
}

/// One vector of every record as a flat array; `member(record)` is a reference to it.
template <class Records, class Member, class Field>
void visit_member(std::string const& name, Records& records, Member&& member, Field&& field) {
  using Value = std::remove_cvref_t<decltype(member(records.front()))>;
  std::vector<Value> values;
  for (auto& record : records)
    values.push_back(member(record));
  field(name, values);
  VALIDATE(values.size() == records.size(),
           "restart: the contacts with its tools do not fit together. Is the file damaged?");
  for (std::size_t k = 0; k < values.size(); ++k)
    member(records[k]) = values[k];
}

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
  field("contacts/outer_tool_yielded", state.contacts.outer_tool_yielded);
  field("contacts/inner_tool_yielded", state.contacts.inner_tool_yielded);
  field("contacts/outer_tool_extent", state.contacts.outer_tool_extent);
  field("contacts/inner_tool_extent", state.contacts.inner_tool_extent);
  field("contacts/outer_tool_present", state.contacts.outer_tool_present);
  field("contacts/inner_tool_present", state.contacts.inner_tool_present);
  auto& yields = state.contacts.yields;
  visit_places("contacts/yields/", yields, field);
  visit_member(
      "contacts/yields/displacement", yields,
      [](auto& y) -> Vec3& { return y.motion.displacement; }, field);
  visit_member(
      "contacts/yields/velocity", yields, [](auto& y) -> Vec3& { return y.motion.velocity; },
      field);
  visit_member(
      "contacts/yields/impulse", yields, [](auto& y) -> Vec3& { return y.impulse; }, field);
  auto& impulses = state.contacts.impulses;
  visit_places("contacts/impulses/", impulses, field);
  visit_member(
      "contacts/impulses/tool", impulses, [](auto& w) -> std::uint32_t& { return w.tool; }, field);
  visit_member(
      "contacts/impulses/impulse", impulses, [](auto& w) -> Vec3& { return w.impulse; }, field);
  field("contacts/spring", state.contacts.spring);
  field("contacts/normal_memory", state.contacts.normal_memory);
  field("contacts/outer_builds", state.contacts.outer_builds);
  field("contacts/inner_builds", state.contacts.inner_builds);
  field("tools/displacement", state.tool_displacement);
  field("tools/velocity", state.tool_velocity);
  field("tools/force", state.tool_force);
  field("tools/radial_force", state.tool_radial_force);
  field("tools/work", state.tool_work);
  field("tools/yielded", state.tool_yielded);
  field("tools/yield_work", state.tool_yield_work);
  field("tools/present", state.tool_present);
  field("energy/normal_damping", state.energy.normal_damping);
  field("energy/plastic_work", state.energy.plastic_work);
  field("energy/tangential_work", state.energy.tangential_work);
  field("energy/rolling_work", state.energy.rolling_work);
  field("energy/gravity_work", state.energy.gravity_work);
  field("time", state.time);
  field("window_time", state.window_time);
  field("step", state.step);
}

} // namespace dem
