#pragma once

#include "dem/vec3.hpp"

#include <cstdint>
#include <functional>
#include <span>
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

/// Contacts to be looked at one after the other: those of a list, or those of a world, which are
/// then never all in memory at once.
class ContactStream {
public:
  using Visit = std::function<void(Contact const&)>;
  ContactStream() = default;
  ContactStream(std::span<Contact const> contacts) : contacts_(contacts) {}
  ContactStream(std::vector<Contact> const& contacts) : contacts_(contacts) {}
  explicit ContactStream(World const& world) : world_(&world) {}

  /// Every active contact, in the order of the list, or of the world's rows.
  void for_each(Visit const& visit) const;

private:
  std::span<Contact const> contacts_;
  World const* world_ = nullptr; ///< read instead of the list unless null
};

} // namespace dem
