#pragma once

#include "dem/spheres.hpp"
#include "dem/vec3.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace dem {

/// One grain of a packing: geometry, motion, and which component of the powder it is.
struct PackedGrain {
  Vec3 position;                ///< [m], centre; z = 0 is the lower punch face, x = y = 0 the axis
  double diameter;              ///< [m], > 0
  std::uint8_t component;       ///< row of the powder's components, from 0
  Vec3 velocity = Vec3::Zero(); ///< [m/s]
  Vec3 spin = Vec3::Zero();     ///< [rad/s]
};

using Packing = std::vector<PackedGrain>;

/// What a packing needs to know of a component of the powder.
struct PackingComponent {
  std::string name;
  double density;        ///< [kg/m^3], > 0
  std::uint8_t material; ///< row of the MaterialTable; one component each
};

/// The grains of a packing, in its order, so that ids are rows of the packing.
Spheres make_spheres(Packing const& packing, std::span<PackingComponent const> components);

/// The packing that grains form now, in the order of their ids. Inverse of make_spheres to the last
/// bit.
/// @throws InvalidInput if a grain's material is that of no component
Packing make_packing(Spheres const& grains, std::span<PackingComponent const> components);

} // namespace dem
