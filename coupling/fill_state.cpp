#include "coupling/fill_state.hpp"

#include "coupling/press_grains.hpp"

namespace coupling {
namespace {

/// Settling is the stage that `Settle time` puts before the programme.
bool is_settling(Press const& press) {
  return press.setup.powder.settle_time > 0.0 && press.programme.index() == 0;
}

} // namespace

dem::MaterialTable materials_now(Press const& press) {
  double const missing = is_settling(press) ? press.setup.powder.fill_state : 0.0;
  return make_materials(press.setup, 1.0 - missing);
}

void change_materials(Press& press) {
  if (press.setup.powder.fill_state == 0.0)
    return;
  dem::World& world = press.world;
  world.materials = materials_now(press);
  // Contacts keep constants of their materials, and form them anew where they are restored.
  world.contacts.restore(world, world.contacts.capture());
}

} // namespace coupling
