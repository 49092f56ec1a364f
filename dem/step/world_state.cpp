#include "dem/expect.hpp"
#include "dem/step/visit_state.hpp"

namespace dem {

WorldState capture_state(World const& world) {
  WorldState state{.grains = world.grains,
                   .contacts = world.contacts.capture(),
                   .tool_displacement = {},
                   .tool_velocity = {},
                   .tool_force = {},
                   .tool_radial_force = {},
                   .tool_work = {},
                   .tool_yielded = {},
                   .tool_yield_work = {},
                   .tool_present = {},
                   .energy = world.energy,
                   .time = world.time,
                   .window_time = world.window_time,
                   .step = world.step};
  for (Tool const& tool : world.tools) {
    state.tool_displacement.push_back(tool.displacement);
    state.tool_velocity.push_back(tool.velocity);
    state.tool_force.push_back(tool.force);
    state.tool_radial_force.push_back(tool.radial_force);
    state.tool_work.push_back(tool.work);
    state.tool_yielded.push_back(tool.yielded);
    state.tool_yield_work.push_back(tool.yield_work);
    state.tool_present.push_back(tool.present ? 1 : 0);
  }
  return state;
}

void restore_state(World& world, WorldState const& state) {
  Spheres const& g = state.grains;
  auto const same = [n = g.position.size()](auto const&... v) { return ((v.size() == n) && ...); };
  VALIDATE(same(g.velocity, g.spin, g.force, g.torque, g.radius, g.mass, g.material, g.id),
           "restart: the arrays of the grains differ in length. Is the file damaged?");
  VALIDATE(state.tool_displacement.size() == world.tools.size() &&
               state.tool_velocity.size() == world.tools.size() &&
               state.tool_force.size() == world.tools.size() &&
               state.tool_radial_force.size() == world.tools.size() &&
               state.tool_work.size() == world.tools.size() &&
               state.tool_yielded.size() == world.tools.size() &&
               state.tool_yield_work.size() == world.tools.size() &&
               state.tool_present.size() == world.tools.size(),
           "restart: it holds another number of tools than the case. Is it from another case?");
  world.grains = g;
  for (std::size_t t = 0; t < world.tools.size(); ++t) {
    Tool& tool = world.tools[t];
    tool.displacement = state.tool_displacement[t];
    tool.velocity = state.tool_velocity[t];
    tool.force = state.tool_force[t];
    tool.radial_force = state.tool_radial_force[t];
    tool.work = state.tool_work[t];
    tool.yielded = state.tool_yielded[t];
    tool.yield_work = state.tool_yield_work[t];
    tool.present = state.tool_present[t] != 0;
  }
  world.energy = state.energy;
  world.time = state.time;
  world.window_time = state.window_time;
  world.step = state.step;
  world.contacts.restore(world, state.contacts);
}

} // namespace dem
