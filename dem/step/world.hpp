#pragma once

#include "dem/contact/contact_choice.hpp"
#include "dem/contact/contact_engine.hpp"
#include "dem/material.hpp"
#include "dem/spheres.hpp"
#include "dem/surface/tool.hpp"
#include "dem/vec3.hpp"

#include <cstdint>
#include <vector>

namespace dem {

/// Energies that only the sweep can see, summed over all steps so far [J].
struct EnergyTally {
  double normal_damping = 0.0;  ///< lost in normal dashpots
  double tangential_work = 0.0; ///< put into tangential springs, dashpots and sliding
  double rolling_work = 0.0;    ///< lost in rolling resistance
  double plastic_work = 0.0;    ///< lost to plastic deformation of contacts
  double gravity_work = 0.0;    ///< done by gravity on the grains
};

/// Everything the grains' step needs. Copyable: a saved state is a copy.
struct World {
  Spheres grains;
  MaterialTable materials;
  std::vector<Tool> tools;
  Vec3 gravity = Vec3(0.0, 0.0, -9.81); ///< [m/s^2]
  double time = 0.0;                    ///< [s]
  double window_time = 0.0;             ///< [s], since deformable tools last changed their course
  std::uint64_t step = 0;
  EnergyTally energy;
  ContactEngine contacts; ///< neighbour lists, contact history, laws
};

} // namespace dem
