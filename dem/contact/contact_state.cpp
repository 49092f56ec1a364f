#include "dem/contact/contact_store.hpp"

#include "dem/expect.hpp"

#include <algorithm>

/// What a restart keeps of the contacts: lists as they stand, springs, memories.
namespace dem {

template <class T> ContactState TypedStore<T>::capture() const {
  EXPECT(!is_open_);
  ContactState state{.outer_position = lists_.outer.position,
                     .inner_position = lists_.inner.position,
                     .outer_skin = lists_.outer.skin,
                     .inner_skin = lists_.inner.skin,
                     .outer_tool = lists_.outer.tool,
                     .inner_tool = lists_.inner.tool,
                     .outer_tool_skin = lists_.outer.tool_skin,
                     .inner_tool_skin = lists_.inner.tool_skin,
                     .outer_tool_yielded = lists_.outer.tool_yielded,
                     .inner_tool_yielded = lists_.inner.tool_yielded,
                     .outer_tool_extent = lists_.outer.tool_extent,
                     .inner_tool_extent = lists_.inner.tool_extent,
                     .outer_tool_present = lists_.outer.tool_present,
                     .inner_tool_present = lists_.inner.tool_present,
                     .spring = {},
                     .normal_memory = {},
                     .yields = {},
                     .impulses = impulses_,
                     .outer_builds = lists_.outer_builds,
                     .inner_builds = lists_.inner_builds};
  for (ContactBlock<T> const& block : lists_.blocks) {
    auto const keep = [&](std::size_t at) {
      auto const m = block.remembered(at);
      state.spring.emplace_back(m[0], m[1], m[2]);
      state.normal_memory.push_back(m[3]);
    };
    for (std::size_t k = 0; k < block.n_pairs; ++k)
      keep(k);
    for (std::size_t k = 0; k < block.walls.size(); ++k)
      keep(block.wall_offset + k);
    state.yields.insert(state.yields.end(), block.yields.begin(), block.yields.end());
  }
  return state;
}

template <class T> void TypedStore<T>::restore(World& world, ContactState const& state) {
  std::size_t const n = world.grains.size();
  VALIDATE(state.outer_position.size() == n && state.inner_position.size() == n &&
               state.outer_skin.size() == n && state.inner_skin.size() == n &&
               state.inner_tool.size() == world.tools.size() &&
               state.outer_tool.size() == world.tools.size() &&
               state.inner_tool_extent.size() == world.tools.size() &&
               state.outer_tool_extent.size() == world.tools.size() &&
               state.inner_tool_yielded.size() == world.tools.size() &&
               state.outer_tool_yielded.size() == world.tools.size() &&
               state.inner_tool_present.size() == world.tools.size() &&
               state.outer_tool_present.size() == world.tools.size(),
           "restart: the contact lists do not belong to these grains and tools. Is the file from "
           "another case?");
  lists_ = {};
  is_open_ = false;
  lists_.outer = {state.outer_position,    state.outer_skin,         state.outer_tool,
                  state.outer_tool_skin,   state.outer_tool_yielded, state.outer_tool_extent,
                  state.outer_tool_present};
  lists_.inner = {state.inner_position,    state.inner_skin,         state.inner_tool,
                  state.inner_tool_skin,   state.inner_tool_yielded, state.inner_tool_extent,
                  state.inner_tool_present};
  impulses_ = state.impulses;
  double const beyond = reach(world);
  build_outer(world, beyond, lists_);
  CarriedContacts<T> none;
  none.start.assign(n + 1, 0);
  build_inner(world, kernel_, choice_, beyond, none, lists_);
  lists_.outer_builds = state.outer_builds;
  lists_.inner_builds = state.inner_builds;
  travel_.clear();
  std::size_t next = 0, next_yield = 0;
  for (ContactBlock<T>& block : lists_.blocks) {
    VALIDATE(next_yield + block.yields.size() <= state.yields.size(),
             "restart: fewer contacts follow deformable tools than there are. Is the file from "
             "another version?");
    for (WallYield& yield : block.yields)
      yield = state.yields[next_yield++];
    VALIDATE(next + block.n_pairs + block.walls.size() <= state.spring.size() &&
                 state.spring.size() == state.normal_memory.size(),
             "restart: fewer contact springs than contacts. Is the file from another version?");
    auto const put = [&](std::size_t at) {
      Vec3 const& spring = state.spring[next];
      block.remember(at, {static_cast<T>(spring.x()), static_cast<T>(spring.y()),
                          static_cast<T>(spring.z()), static_cast<T>(state.normal_memory[next])});
      ++next;
    };
    for (std::size_t k = 0; k < block.n_pairs; ++k)
      put(k);
    for (std::size_t k = 0; k < block.walls.size(); ++k)
      put(block.wall_offset + k);
  }
  VALIDATE(next == state.spring.size() && next_yield == state.yields.size(),
           "restart: more contact springs than contacts. Is the file from another version?");
}

template ContactState TypedStore<float>::capture() const;
template ContactState TypedStore<double>::capture() const;
template void TypedStore<float>::restore(World&, ContactState const&);
template void TypedStore<double>::restore(World&, ContactState const&);

} // namespace dem
