#pragma once

#include "dem/vec3.hpp"

#include <cstdint>
#include <vector>

namespace dem {

struct World;

/// One active contact, as measured from the present state (full precision, for measures and output;
/// the sweep keeps its own compact form). Row numbers are those of World::grains at the time of the
/// call.
struct Contact {
  static constexpr std::uint32_t none = 0xffffffffu;
  std::uint32_t i;            ///< row of the grain
  std::uint32_t j;            ///< row of the other grain, or `none` at a tool
  std::uint32_t tool;         ///< index in World::tools, or `none`
  std::uint32_t patch;        ///< patch of the tool, or `none`
  std::uint32_t triangle;     ///< triangle of the tool, or `none`
  Vec3 point = Vec3::Zero();  ///< [m], middle of the overlap
  Vec3 normal = Vec3::Zero(); ///< unit, from j (or the tool) to i
  double overlap;             ///< [m], > 0 (or down to minus the law's reach)
  double
      normal_force; ///< [N], cohesion and dashpot included, positive when it pushes i along +normal
  double cohesive_force;                ///< [N], the cohesive part of it, <= 0
  Vec3 tangential_force = Vec3::Zero(); ///< [N], on i
  Vec3 force = Vec3::Zero();            ///< [N], on i, the sum
};

/// Every active contact, sorted by (id of i, id of j or tool and patch).
std::vector<Contact> list_contacts(World const& world);

} // namespace dem
