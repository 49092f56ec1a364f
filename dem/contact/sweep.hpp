#pragma once

#include "dem/contact/model_constants.hpp"
#include "dem/contact/sweep_batch.hpp"

#include <algorithm>
#include <array>

/// The hot loop. Contacts go through three stages in batches: gather, pure arithmetic (the contact
/// model on packs), scatter. The stages let many contacts be in flight at once; one contact at a
/// time would wait for its own square roots.
namespace dem::sweep_detail {

/// The pure stage: the model on every pack of the batch. `at` is the batch's place in the block's
/// streams. Flattened: every law is inlined, so packs stay in registers and never travel through
/// memory as arguments.
template <class Model, class T>
[[gnu::flatten]] void evaluate_batch(Batch<T>& b, std::size_t n, ContactBlock<T>& block,
                                     std::size_t at, SweepInput<T> const& in,
                                     std::array<Pack<T>, 4>& power) {
  using N = Pack<T>;
  constexpr std::size_t lanes = pack_size<T>;
  constexpr std::size_t n_memory = Model::has_memory ? 4 : 3;
  constexpr auto aligned = std::experimental::element_aligned;
  N const dt(static_cast<T>(in.dt));
  ModelSwitches<N> const switches{N(in.switches.cohesion_in_limit), N(in.switches.clip),
                                  N(in.switches.viscous_time)};
  for (std::size_t k = 0; k < n; k += pack_size<T>) {
    N const square_gap(b.square_gap + k, aligned);
    T* const m = block.memory.data() + (at + k) * n_memory;
    ContactMemory<N> memory{};
    if constexpr (Model::has_spring)
      memory.spring = {N(m, aligned), N(m + lanes, aligned), N(m + 2 * lanes, aligned)};
    if constexpr (Model::has_memory)
      memory.normal = N(m + 3 * lanes, aligned);
    ContactInput<N> const input{
        .separation = {N(b.sx + k, aligned), N(b.sy + k, aligned), N(b.sz + k, aligned)},
        .square_gap = square_gap,
        .radius_sum = N(b.radius_sum + k, aligned),
        .radius_i = N(b.radius_i + k, aligned),
        .radius_j = N(b.radius_j + k, aligned),
        .velocity = {N(b.vx + k, aligned), N(b.vy + k, aligned), N(b.vz + k, aligned)},
        .spin_i = {N(b.wix + k, aligned), N(b.wiy + k, aligned), N(b.wiz + k, aligned)},
        .spin_j = {N(b.wjx + k, aligned), N(b.wjy + k, aligned), N(b.wjz + k, aligned)},
        .crowding = N(b.crowding + k, aligned)};
    auto const constants = load_model_constants<Model, N>(
        block.constants.data() + (at + k) * Model::n_constants, lanes);
    ContactOutput<N> const out = Model::evaluate(input, constants, switches, dt, memory);
    if (in.dt > 0.0) {
      if constexpr (Model::has_spring) {
        memory.spring.x.copy_to(m, aligned);
        memory.spring.y.copy_to(m + lanes, aligned);
        memory.spring.z.copy_to(m + 2 * lanes, aligned);
      }
      if constexpr (Model::has_memory)
        memory.normal.copy_to(m + 3 * lanes, aligned);
    }
    out.force.x.copy_to(b.fx + k, aligned);
    out.force.y.copy_to(b.fy + k, aligned);
    out.force.z.copy_to(b.fz + k, aligned);
    out.torque_i.x.copy_to(b.tix + k, aligned);
    out.torque_i.y.copy_to(b.tiy + k, aligned);
    out.torque_i.z.copy_to(b.tiz + k, aligned);
    out.torque_j.x.copy_to(b.tjx + k, aligned);
    out.torque_j.y.copy_to(b.tjy + k, aligned);
    out.torque_j.z.copy_to(b.tjz + k, aligned);
    out.normal_force.copy_to(b.normal_force + k, aligned);
    power[0] += out.normal_loss;
    power[1] += out.tangential_power;
    power[2] += out.rolling_loss;
    if constexpr (PlasticLaw<typename Model::NormalLaw>)
      power[3] += out.plastic_work;
  }
}

template <class Model, class T> void sweep(ContactBlock<T>& block, SweepInput<T> const& in) {
  Batch<T> b;
  std::array<Pack<T>, 4> power{Pack<T>(0), Pack<T>(0), Pack<T>(0), Pack<T>(0)};
  // Of each slot; it stays in the cache from block to block.
  thread_local LineVector<LoadRecord<T>> loads;
  loads.assign(block.rows.size(), LoadRecord<T>{});
  for (std::size_t k = 0; k < block.n_pairs; k += batch) {
    std::size_t const n = std::min(batch, block.n_pairs - k), full = padded<T>(n);
    gather_pairs(b, block, k, (n + 3) / 4 * 4, in);
    blank(b, n, full);
    form_gaps(b, full);
    if (in.crowding)
      crowd_pairs(b, block, k, n, in.crowding);
    evaluate_batch<Model>(b, full, block, k, in, power);
    scatter_pairs(b, block, k, n, loads.data());
  }
  std::vector<SurfacePoint> found;
  for (std::size_t k = 0; k < block.walls.size(); k += batch) {
    std::size_t const n = std::min(batch, block.walls.size() - k), full = padded<T>(n);
    WallYield* const yields = block.yields.empty() ? nullptr : block.yields.data() + k;
    gather_walls(b, block.walls.data() + k, yields, n, in, found);
    blank(b, n, full);
    form_gaps(b, full);
    if (in.crowding)
      crowd_walls(b, block.walls.data() + k, n, in.crowding);
    evaluate_batch<Model>(b, full, block, block.wall_offset + k, in, power);
    scatter_walls(b, n, block.walls.data() + k, yields, in.dt, block.first_row, loads.data());
  }
  std::copy_n(loads.data(), block.n_rows(), in.own_loads + block.first_row);
  for (std::size_t s = block.n_rows(); s < loads.size(); ++s)
    in.halo_loads[block.halo_place[s - block.n_rows()]] = loads[s];
  auto const sum = [](Pack<T> const& p) {
    double total = 0.0;
    for (std::size_t l = 0; l < pack_size<T>; ++l)
      total += static_cast<double>(p[l]);
    return total;
  };
  block.power = {.normal_loss = sum(power[0]),
                 .tangential = sum(power[1]),
                 .rolling = sum(power[2]),
                 .plastic_work = sum(power[3])};
}

} // namespace dem::sweep_detail
