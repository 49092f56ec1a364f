#pragma once

#include "dem/contact/contact.hpp"
#include "dem/step/world.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// What contacts mean for single grains and single triangles: fields for pictures.
namespace coupling {

/// One value per grain, in the rows of World::grains.
struct GrainFields {
  std::vector<double> mean_overlap;      ///< [m], over the grain's contacts; 0 without any
  std::vector<double> pressure;          ///< [Pa], compression positive
  std::vector<std::uint32_t> n_contacts; ///< tools included
};

/// Pressure of a grain from the forces on it:  p = -1/(3 V) sum over contacts of (x_c - x) . f,  V
/// = 4/3 pi R^3. Source: Christoffersen, Mehrabadi and Nemat-Nasser, J. Appl. Mech. 48 (1981) 339
/// (volume average of stress).
GrainFields grain_fields(dem::World const& world, dem::ContactStream const& contacts);

/// The surfaces of all present tools where they stand, as one.
struct ToolFields {
  std::vector<dem::Vec3> vertices; ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint8_t> tool;  ///< index in World::tools, per triangle
  std::vector<dem::Vec3> traction; ///< [Pa], force of the grains / area, per triangle
};

ToolFields tool_fields(dem::World const& world, dem::ContactStream const& contacts);

} // namespace coupling
