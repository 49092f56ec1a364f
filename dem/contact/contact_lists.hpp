#pragma once

#include "dem/contact/contact_block.hpp"
#include "dem/contact/contact_kernel.hpp"
#include "dem/neighbors/pair_list.hpp"
#include "dem/step/world.hpp"

#include <vector>

/// The two-level neighbour list. The outer list (large skin) comes from the grid; the inner list
/// (small skin) is filtered out of it block by block and is what the sweep runs over. Each grain
/// has its own skin, larger the faster it moves, so one fast grain lengthens its own list instead
/// of ending everybody's.
namespace dem {

/// Where everything was when a list was made, and how far it may move before the list ends.
struct ListAge {
  std::vector<Vec3> position;             ///< [m], n_grains
  std::vector<double> skin;               ///< [m], n_grains
  std::vector<Vec3> tool;                 ///< [m], displacement of each tool
  std::vector<double> tool_skin;          ///< [m]
  std::vector<double> tool_yielded;       ///< [m], Tool::yielded at the time
  std::vector<double> tool_extent;        ///< [m], bound of the tool's deformation at the time
  std::vector<std::uint8_t> tool_present; ///< 1 where the tool was there at the time

  /// Bound of the way that any point of a tool's surface has gone since [m].
  double tool_way(Tool const& now, std::size_t t) const {
    return (now.displacement - tool[t]).norm() + (now.yielded - tool_yielded[t]);
  }
};

/// A contact with a history on its way from the old list to the new one.
template <class T> struct CarriedContact {
  std::uint32_t owner;
  std::uint32_t partner; ///< row of the other grain, or tool
  std::uint32_t patch;   ///< of the tool; unused between grains
  ContactRemembers<T> memory;
};

/// Carried contacts sorted by owner.
template <class T> struct CarriedContacts {
  static constexpr std::uint32_t between_grains =
      0xffffffffu; ///< `patch` of a contact between grains
  std::vector<std::uint32_t> start;
  std::vector<CarriedContact<T>> row;

  std::span<CarriedContact<T> const> of(std::uint32_t owner) const {
    return std::span(row).subspan(start[owner], start[owner + 1] - start[owner]);
  }
};

/// How far ahead the lists look.
struct SkinRule {
  double base;    ///< [m]
  double horizon; ///< [s], skin += horizon * speed
  double cap;     ///< [m]
  double skin(double speed) const;
};

/// The mixed values of every pair of materials, looked up by row.
class PairTable {
public:
  explicit PairTable(MaterialTable const& materials);
  PairMaterial const& operator()(std::uint8_t i, std::uint8_t j) const {
    return pairs_[i * n_ + j];
  }

private:
  std::size_t n_;
  std::vector<PairMaterial> pairs_;
};

/// A tool that a grain may reach while the outer list holds.
struct NearTool {
  static constexpr std::uint32_t searched = 0xffffffffu;
  std::uint32_t tool;
  std::uint32_t patch; ///< the only one in reach, met inside its rim all the while, or `searched`
};

template <class T> struct ContactLists {
  ListAge outer, inner;
  PairList pairs;                             ///< outer list
  std::vector<std::uint32_t> near_tool_start; ///< CSR: tools near each grain, outer list
  std::vector<NearTool> near_tool;
  std::vector<ContactBlock<T>> blocks;
  LineVector<LoadRecord<T>> own_loads;   ///< of each grain, from the contacts of its own block
  LineVector<LoadRecord<T>> halo_loads;  ///< of each grain, from those of other blocks
  std::vector<std::uint32_t> halo_start; ///< CSR of halo_loads by grain
  std::uint64_t outer_builds = 0, inner_builds = 0;
};

/// Takes the contacts with a history out of the blocks, which are empty afterwards; their rows are
/// renumbered: row r of the old order is new_row[r] (empty: unchanged).
template <class T>
CarriedContacts<T> carry(ContactLists<T>& lists, std::span<std::uint32_t const> new_row,
                         std::size_t n_grains);

/// Outer list of the present positions. `lists.outer` says where and how far.
template <class T> void build_outer(World const& world, double reach, ContactLists<T>& lists);

/// Inner list out of the outer one. `lists.inner` says where and how far; histories come from
/// `carried`.
template <class T>
void build_inner(World const& world, ContactKernel<T> const& kernel, ContactChoice const& choice,
                 double reach, CarriedContacts<T> const& carried, ContactLists<T>& lists);

extern template struct ContactLists<float>;
extern template struct ContactLists<double>;

} // namespace dem
