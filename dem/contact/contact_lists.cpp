#include "dem/contact/contact_lists.hpp"

#include "dem/contact/list_filter.hpp"

#include <algorithm>
#include <numeric>

namespace dem {

PairTable::PairTable(MaterialTable const& materials) : n_(materials.size()) {
  for (std::size_t i = 0; i < n_; ++i)
    for (std::size_t j = 0; j < n_; ++j)
      pairs_.push_back(materials.pair(static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j)));
}

double SkinRule::skin(double speed) const {
  return std::min(base + horizon * speed, cap);
}

namespace {

/// Half of one step towards the new list: renumbers a contact and turns it round if its owner
/// changed.
template <class T>
CarriedContact<T> renumber(CarriedContact<T> c, std::span<std::uint32_t const> new_row,
                           bool is_wall) {
  if (new_row.empty())
    return c;
  c.owner = new_row[c.owner];
  if (is_wall)
    return c;
  c.partner = new_row[c.partner];
  if (c.owner > c.partner) {
    std::swap(c.owner, c.partner);
    for (std::size_t s = 0; s < 3; ++s)
      c.memory[s] = -c.memory[s]; // the spring is seen from the owner
  }
  return c;
}

/// visit(contact) for every contact of a block that remembers something, in the old order.
template <class T, class Visit>
void for_each_carried(ContactBlock<T> const& block, std::span<std::uint32_t const> new_row,
                      Visit&& visit) {
  auto const take = [&](std::size_t at, CarriedContact<T> c, bool is_wall) {
    c.memory = block.remembered(at);
    if (c.memory != ContactRemembers<T>{})
      visit(renumber(c, new_row, is_wall));
  };
  for (std::size_t k = 0; k < block.n_pairs; ++k)
    take(k,
         {block.rows[block.owner[k]],
          block.rows[block.partner[k]],
          CarriedContacts<T>::between_grains,
          {}},
         false);
  for (std::size_t k = 0; k < block.walls.size(); ++k)
    take(block.wall_offset + k,
         {block.walls[k].owner, block.walls[k].tool, block.walls[k].patch, {}}, true);
}

} // namespace

template <class T>
CarriedContacts<T> carry(ContactLists<T>& lists, std::span<std::uint32_t const> new_row,
                         std::size_t n_grains) {
  CarriedContacts<T> carried;
  carried.start.assign(n_grains + 1, 0);
  for (ContactBlock<T> const& block : lists.blocks)
    for_each_carried(block, new_row, [&](auto const& c) { ++carried.start[c.owner + 1]; });
  std::partial_sum(carried.start.begin(), carried.start.end(), carried.start.begin());
  carried.row.resize(carried.start.back());
  std::vector<std::uint32_t> next(carried.start.begin(), carried.start.end() - 1);
  for (ContactBlock<T>& block : lists.blocks) {
    for_each_carried(block, new_row, [&](auto const& c) { carried.row[next[c.owner]++] = c; });
    block = {}; // its streams are the largest thing there is: not held beside what they carried
  }
  return carried;
}

template <class T> void build_outer(World const& world, double reach, ContactLists<T>& lists) {
  std::size_t const n = world.grains.size();
  std::vector<double> total(n);
  for (std::size_t i = 0; i < n; ++i)
    total[i] = world.grains.radius[i] + lists.outer.skin[i] + 0.5 * reach;
  lists.pairs = {}; // the old list goes before the new one comes
  lists.pairs = find_pairs(lists.outer.position, total);

  std::vector<std::vector<NearTool>> near(n);
#pragma omp parallel for schedule(dynamic, 256) if (n > 256)
  for (std::size_t i = 0; i < n; ++i)
    near[i] = tools_near(world, lists.outer, i, reach);
  lists.near_tool_start.assign(n + 1, 0);
  lists.near_tool.clear();
  for (std::size_t i = 0; i < n; ++i) {
    lists.near_tool.insert(lists.near_tool.end(), near[i].begin(), near[i].end());
    lists.near_tool_start[i + 1] = static_cast<std::uint32_t>(lists.near_tool.size());
  }
}

template <class T>
void build_inner(World const& world, ContactKernel<T> const& kernel, ContactChoice const& choice,
                 double reach, CarriedContacts<T> const& carried, ContactLists<T>& lists) {
  std::size_t const n = world.grains.size();
  // Of n alone: the same bits on any number of threads.
  std::size_t const block_rows = n < 8192 ? 256 : 512;
  PairTable const table(world.materials);
  lists.blocks.resize((n + block_rows - 1) / block_rows);
#pragma omp parallel for schedule(dynamic, 1) if (lists.blocks.size() > 1)
  for (std::size_t b = 0; b < lists.blocks.size(); ++b) {
    lists.blocks[b].first_row = static_cast<std::uint32_t>(b * block_rows);
    lists.blocks[b].end_row = static_cast<std::uint32_t>(std::min(n, (b + 1) * block_rows));
    fill_block(world, kernel, choice, table, reach, carried, lists, lists.blocks[b]);
  }
  lists.halo_start.assign(n + 1, 0);
  for (auto const& block : lists.blocks)
    for (std::size_t s = block.n_rows(); s < block.rows.size(); ++s)
      ++lists.halo_start[block.rows[s] + 1];
  std::partial_sum(lists.halo_start.begin(), lists.halo_start.end(), lists.halo_start.begin());
  lists.own_loads.resize(n);
  lists.halo_loads.resize(lists.halo_start.back());
  std::vector<std::uint32_t> next(lists.halo_start.begin(), lists.halo_start.end() - 1);
  for (auto& block : lists.blocks) {
    block.halo_place.clear();
    for (std::size_t s = block.n_rows(); s < block.rows.size(); ++s)
      block.halo_place.push_back(next[block.rows[s]]++);
  }
}

#define PRESSCHECK_LISTS(T)                                                                        \
  template struct ContactLists<T>;                                                                 \
  template CarriedContacts<T> carry(ContactLists<T>&, std::span<std::uint32_t const>,              \
                                    std::size_t);                                                  \
  template void build_outer(World const&, double, ContactLists<T>&);                               \
  template void build_inner(World const&, ContactKernel<T> const&, ContactChoice const&, double,   \
                            CarriedContacts<T> const&, ContactLists<T>&);
PRESSCHECK_LISTS(float)
PRESSCHECK_LISTS(double)
#undef PRESSCHECK_LISTS

} // namespace dem
