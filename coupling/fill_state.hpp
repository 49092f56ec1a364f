#pragma once

#include "coupling/press.hpp"

namespace coupling {

/// The materials of the present stage. With `Powder/Fill state` s the static friction of every
/// contact is (1 - s) of the case's while grains settle, and all of it from then on.
dem::MaterialTable materials_now(Press const& press);

/// Lets contacts that are there already take up the materials of the stage that begins. Springs and
/// lists stay as they are; a spring beyond its new limit slides in the next step.
void change_materials(Press& press);

} // namespace coupling
