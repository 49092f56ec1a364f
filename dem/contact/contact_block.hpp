#pragma once

#include "dem/contact/pack.hpp"
#include "dem/surface/tool_deformation.hpp"

#include <array>
#include <cstdint>
#include <new>
#include <vector>

namespace dem {

/// Allocator for arrays that vector loads read: 64-byte lines.
template <class T> struct LineAllocator {
  using value_type = T;
  LineAllocator() = default;
  template <class U> LineAllocator(LineAllocator<U> const&) {}
  T* allocate(std::size_t n) {
    return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{64}));
  }
  void deallocate(T* p, std::size_t) { ::operator delete (p, std::align_val_t{64}); }
  friend bool operator==(LineAllocator const&, LineAllocator const&) { return true; }
};
template <class T> using LineVector = std::vector<T, LineAllocator<T>>;

/// Velocity and spin of a grain in the number type of the sweep. The radius fills the line: its two
/// parts add up to it in double, because the gap is formed there.
template <class T> struct alignas(8 * sizeof(T)) MotionRecord {
  T vx, vy, vz, radius_rest, wx, wy, wz, radius;
};

/// Force and torque of one sweep.
template <class T> struct alignas(8 * sizeof(T)) LoadRecord {
  T fx, fy, fz, unused_f, tx, ty, tz, unused_t;
};

/// A grain at a tool: where the contact is and what it carried in the last step.
struct WallContact {
  std::uint32_t owner; ///< row of the grain
  std::uint32_t tool;
  std::uint32_t patch;
  bool inside_rim;   ///< the closest point stays inside the patch while this list holds: no search
                     ///< needed
  double px, py, pz; ///< contact point in space [m]
  double fx, fy, fz; ///< force on the grain [N]
  double normal_force; ///< [N]
};

/// What a contact with a deformable tool follows, and what it gave the tool in this window.
struct WallYield {
  SurfacePlace place;
  ToolDeformation::Motion motion;
  Vec3 impulse = Vec3::Zero(); ///< [N s], on the tool
};

/// Power and losses of one sweep over one block.
struct BlockPower {
  double normal_loss = 0.0, tangential = 0.0, rolling = 0.0; ///< [W]
  double plastic_work = 0.0;                                 ///< [J], of the step
};

/// What one contact remembers: spring x y z [m], and the memory of the normal law if it has one.
template <class T> using ContactRemembers = std::array<T, 4>;

/// A run of grains that follow each other along the space-filling curve, with the contacts that
/// they own. A block writes the loads of its own grains, and of each foreign partner (the halo)
/// into a place of its own that lies beside those of other blocks for the same grain, in the order
/// of the blocks. They are summed in this order, so the result does not depend on which thread did
/// which block. First come the pairs sorted by (owner, partner), then the walls sorted by (owner,
/// tool, patch); each part is padded to full packs. `constants` and `memory` hold, pack by pack,
/// all of a pack's first numbers, then all its second ones, and so on: the sweep reads each as one
/// stream.
template <class T> struct ContactBlock {
  std::uint32_t first_row = 0, end_row = 0;
  std::uint32_t n_pairs = 0;
  std::vector<std::uint16_t> owner;   ///< slot of the grain, pairs only
  std::vector<std::uint16_t> partner; ///< slot of the other grain, pairs only
  std::vector<WallContact> walls;
  std::vector<WallYield> yields; ///< of each wall; empty if every tool is rigid
  std::vector<std::uint32_t>
      rows; ///< row of each slot: the block's own, then the foreign partners, sorted
  std::size_t wall_offset = 0; ///< contacts before the first wall, padding included
  int n_memory = 0;            ///< numbers that a contact remembers, see ContactRemembers
  LineVector<T> constants;
  LineVector<T> memory;
  std::vector<std::uint32_t> halo_place; ///< of the foreign partners, in ContactLists::halo_loads
  BlockPower power;

  std::uint32_t n_rows() const { return end_row - first_row; }
  /// Where number `s` of contact `at` is among streams of `n` numbers a contact.
  static std::size_t entry(std::size_t at, int s, int n) {
    constexpr std::size_t lanes = pack_size<T>;
    return (at / lanes * static_cast<std::size_t>(n) + static_cast<std::size_t>(s)) * lanes +
           at % lanes;
  }
  ContactRemembers<T> remembered(std::size_t at) const {
    ContactRemembers<T> m{};
    for (int s = 0; s < n_memory; ++s)
      m[static_cast<std::size_t>(s)] = memory[entry(at, s, n_memory)];
    return m;
  }
  void remember(std::size_t at, ContactRemembers<T> const& m) {
    for (int s = 0; s < n_memory; ++s)
      memory[entry(at, s, n_memory)] = m[static_cast<std::size_t>(s)];
  }
};

/// n rounded up to whole packs.
template <class T> std::size_t padded(std::size_t n) {
  return (n + pack_size<T> - 1) / pack_size<T> * pack_size<T>;
}

} // namespace dem
