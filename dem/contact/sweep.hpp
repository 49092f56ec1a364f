#pragma once

#include "dem/contact/contact_block.hpp"
#include "dem/contact/contact_kernel.hpp"
#include "dem/contact/contact_model.hpp"
#include "dem/contact/lanes.hpp"
#include "dem/surface/tool.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

/// The hot loop. Contacts go through three stages in batches: gather (records of both grains into
/// arrays), pure arithmetic (the contact model on packs), scatter (forces into the block's load
/// buffer). The stages let many contacts be in flight at once; one contact at a time would wait for
/// its own square roots.
namespace dem::sweep_detail {

inline constexpr std::size_t batch = 64;

/// One batch, one array a component.
template <class T> struct alignas(64) Batch {
  double x[batch], y[batch], z[batch], unused[batch]; // separation in double: the gap comes from it
  T sx[batch], sy[batch], sz[batch], square_gap[batch], radius_sum[batch];
  T vx[batch], vy[batch], vz[batch], radius_rest[batch]; // of both radii
  T wix[batch], wiy[batch], wiz[batch], radius_i[batch];
  T wjx[batch], wjy[batch], wjz[batch], radius_j[batch];
  T fx[batch], fy[batch], fz[batch];
  T tix[batch], tiy[batch], tiz[batch];
  T tjx[batch], tjy[batch], tjz[batch], normal_force[batch];
};

template <class T>
void gather_pairs(Batch<T>& b, ContactBlock<T> const& block, std::size_t first, std::size_t n,
                  SweepInput<T> const& in) {
  std::uint16_t const* const owner = block.owner.data() + first;
  std::uint16_t const* const partner = block.partner.data() + first;
  std::uint32_t const* const rows = block.rows.data();
  for (std::size_t k = 0; k < n; k += 4) {
    Lanes<double> place[4];
    Lanes<T> velocity[4], spin_i[4], spin_j[4];
    for (std::size_t l = 0; l < 4; ++l) {
      std::uint32_t const i = rows[owner[k + l]], j = rows[partner[k + l]];
      Vec3 const &xi = in.grains.position[i], &xj = in.grains.position[j];
      place[l] = Lanes<double>{xi[0], xi[1], xi[2], 0.0} - Lanes<double>{xj[0], xj[1], xj[2], 0.0};
      MotionRecord<T> const& mi = in.motions[i];
      MotionRecord<T> const& mj = in.motions[j];
      Lanes<T> const vi = load_lanes(&mi.vx), vj = load_lanes(&mj.vx);
      velocity[l] = __builtin_shufflevector(vi - vj, vi + vj, 0, 1, 2, 7);
      spin_i[l] = load_lanes(&mi.wx);
      spin_j[l] = load_lanes(&mj.wx);
    }
    auto const spread = [k](auto(&quad)[4], auto* x, auto* y, auto* z, auto* w) {
      transpose(quad[0], quad[1], quad[2], quad[3]);
      store_lanes(x + k, quad[0]);
      store_lanes(y + k, quad[1]);
      store_lanes(z + k, quad[2]);
      store_lanes(w + k, quad[3]);
    };
    spread(place, b.x, b.y, b.z, b.unused);
    spread(velocity, b.vx, b.vy, b.vz, b.radius_rest);
    spread(spin_i, b.wix, b.wiy, b.wiz, b.radius_i);
    spread(spin_j, b.wjx, b.wjy, b.wjz, b.radius_j);
  }
}

/// A tool is a partner of the grain's own radius that stands behind the surface: its surface point
/// and normal are the tool's, and the distance keeps its sign however deep the grain goes.
template <class T>
void gather_walls(Batch<T>& b, WallContact* walls, WallYield const* yields, std::size_t n,
                  SweepInput<T> const& in, std::vector<SurfacePoint>& found) {
  for (std::size_t k = 0; k < n; ++k) {
    WallContact& wall = walls[k];
    Tool const& tool = in.tools[wall.tool];
    double const radius = in.grains.radius[wall.owner];
    MotionRecord<T> const& motion = in.motions[wall.owner];
    Vec3 shift = tool.displacement, velocity = tool.velocity;
    if (yields) {
      auto const& [displacement, speed] = yields[k].motion;
      shift += displacement + in.window_time * speed;
      velocity += speed;
    }
    Vec3 const centre = in.grains.position[wall.owner] - shift;
    double distance = 2.0 * radius; // nothing there: as far as a partner that does not touch
    Vec3 normal = Vec3::UnitZ(), point = centre;
    if (tool.present) {
      if (wall.inside_rim) {
        SurfacePoint const at = tool.surface.on_patch(wall.patch, centre);
        distance = at.distance, normal = at.normal, point = at.point;
      } else {
        found.clear();
        tool.surface.find(centre, 1.2 * radius, found);
        for (SurfacePoint const& at : found)
          if (at.patch == wall.patch)
            distance = at.distance, normal = at.normal, point = at.point;
      }
    }
    wall.px = point.x() + shift.x(), wall.py = point.y() + shift.y();
    wall.pz = point.z() + shift.z();
    Vec3 const separation = (radius + distance) * normal;
    b.x[k] = separation.x(), b.y[k] = separation.y(), b.z[k] = separation.z();
    b.vx[k] = motion.vx - static_cast<T>(velocity.x());
    b.vy[k] = motion.vy - static_cast<T>(velocity.y());
    b.vz[k] = motion.vz - static_cast<T>(velocity.z());
    b.wix[k] = motion.wx, b.wiy[k] = motion.wy, b.wiz[k] = motion.wz;
    b.wjx[k] = b.wjy[k] = b.wjz[k] = T(0);
    b.radius_i[k] = b.radius_j[k] = motion.radius;
    b.radius_rest[k] = 2 * motion.radius_rest;
  }
}

/// Lanes beyond the last contact: two points apart, without a gap.
template <class T> void blank(Batch<T>& b, std::size_t first, std::size_t end) {
  for (std::size_t k = first; k < end; ++k) {
    b.x[k] = 3.0, b.y[k] = b.z[k] = 0.0;
    b.vx[k] = b.vy[k] = b.vz[k] = b.wix[k] = b.wiy[k] = b.wiz[k] = b.wjx[k] = b.wjy[k] = b.wjz[k] =
        b.radius_rest[k] = T(0);
    b.radius_i[k] = b.radius_j[k] = T(1);
  }
}

template <class T> void form_gaps(Batch<T>& b, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    double const square = b.x[k] * b.x[k] + b.y[k] * b.y[k] + b.z[k] * b.z[k];
    double const sum = static_cast<double>(b.radius_i[k]) + static_cast<double>(b.radius_j[k]) +
                       static_cast<double>(b.radius_rest[k]);
    b.square_gap[k] = static_cast<T>(sum * sum - square);
    b.sx[k] = static_cast<T>(b.x[k]);
    b.sy[k] = static_cast<T>(b.y[k]);
    b.sz[k] = static_cast<T>(b.z[k]);
    b.radius_sum[k] = static_cast<T>(sum);
  }
}

/// Constants of a law, `stride` numbers apart.
template <class C, class N, class T, std::size_t... S>
C load_constants(T const* at, std::size_t stride, std::index_sequence<S...>) {
  [[maybe_unused]] auto const load = [&](std::size_t s) {
    if constexpr (std::is_same_v<N, T>)
      return at[s * stride];
    else
      return N(at + s * stride, std::experimental::element_aligned);
  };
  return C{load(S)...};
}

template <class Model, class N, class T>
typename Model::template Constants<N> load_model_constants(T const* at, std::size_t stride) {
  using C = typename Model::template Constants<N>;
  constexpr std::size_t n = Model::NormalLaw::n_constants, c = Model::CohesionLaw::n_constants,
                        t = Model::TangentialLaw::n_constants, r = Model::RollingLaw::n_constants;
  return C{load_constants<decltype(C::normal), N>(at, stride, std::make_index_sequence<n>{}),
           load_constants<decltype(C::cohesion), N>(at + n * stride, stride,
                                                    std::make_index_sequence<c>{}),
           load_constants<decltype(C::tangential), N>(at + (n + c) * stride, stride,
                                                      std::make_index_sequence<t>{}),
           load_constants<decltype(C::rolling), N>(at + (n + c + t) * stride, stride,
                                                   std::make_index_sequence<r>{})};
}

/// The pure stage: the model on every pack of the batch. `at` is the batch's place in the block's
/// streams. Flattened: every law is inlined, so packs stay in registers and never travel through
/// memory as arguments.
template <class Model, class T>
[[gnu::flatten]] void evaluate_batch(Batch<T>& b, std::size_t n, ContactBlock<T>& block,
                                     std::size_t at, SweepInput<T> const& in,
                                     std::array<Pack<T>, 3>& power) {
  using N = Pack<T>;
  constexpr std::size_t lanes = pack_size<T>;
  constexpr std::size_t n_memory = Model::has_memory ? 4 : 3;
  constexpr auto aligned = std::experimental::element_aligned;
  N const dt(static_cast<T>(in.dt));
  ModelSwitches<N> const switches{N(in.switches.cohesion_in_limit), N(in.switches.clip)};
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
        .spin_j = {N(b.wjx + k, aligned), N(b.wjy + k, aligned), N(b.wjz + k, aligned)}};
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
  }
}

template <class T> void add(LoadRecord<T>& record, Lanes<T> force, Lanes<T> torque) {
  store_lanes(&record.fx, load_lanes(&record.fx) + force);
  store_lanes(&record.tx, load_lanes(&record.tx) + torque);
}

template <class T>
void scatter_pairs(Batch<T> const& b, ContactBlock<T> const& block, std::size_t first,
                   std::size_t n, LoadRecord<T>* loads) {
  std::uint16_t const* const owner = block.owner.data() + first;
  std::uint16_t const* const partner = block.partner.data() + first;
  for (std::size_t k = 0; k < n; k += 4) {
    Lanes<T> zero = {};
    Lanes<T> f[4] = {load_lanes(b.fx + k), load_lanes(b.fy + k), load_lanes(b.fz + k), zero};
    Lanes<T> ti[4] = {load_lanes(b.tix + k), load_lanes(b.tiy + k), load_lanes(b.tiz + k), zero};
    Lanes<T> tj[4] = {load_lanes(b.tjx + k), load_lanes(b.tjy + k), load_lanes(b.tjz + k), zero};
    transpose(f[0], f[1], f[2], f[3]);
    transpose(ti[0], ti[1], ti[2], ti[3]);
    transpose(tj[0], tj[1], tj[2], tj[3]);
    std::size_t const last = std::min<std::size_t>(4, n - k);
    for (std::size_t l = 0; l < last; ++l) {
      add(loads[owner[k + l]], f[l], ti[l]);
      add(loads[partner[k + l]], -f[l], tj[l]);
    }
  }
}

template <class T>
void scatter_walls(Batch<T> const& b, std::size_t n, WallContact* walls, WallYield* yields,
                   double dt, std::uint32_t first_row, LoadRecord<T>* loads) {
  for (std::size_t k = 0; k < n; ++k) {
    LoadRecord<T>& r = loads[walls[k].owner - first_row];
    r.fx += b.fx[k], r.fy += b.fy[k], r.fz += b.fz[k];
    r.tx += b.tix[k], r.ty += b.tiy[k], r.tz += b.tiz[k];
    walls[k].fx = b.fx[k], walls[k].fy = b.fy[k], walls[k].fz = b.fz[k];
    walls[k].normal_force = b.normal_force[k];
    if (yields)
      yields[k].impulse -= dt * Vec3(b.fx[k], b.fy[k], b.fz[k]);
  }
}

template <class Model, class T> void sweep(ContactBlock<T>& block, SweepInput<T> const& in) {
  Batch<T> b;
  std::array<Pack<T>, 3> power{Pack<T>(0), Pack<T>(0), Pack<T>(0)};
  // Of each slot; it stays in the cache from block to block.
  thread_local LineVector<LoadRecord<T>> loads;
  loads.assign(block.rows.size(), LoadRecord<T>{});
  for (std::size_t k = 0; k < block.n_pairs; k += batch) {
    std::size_t const n = std::min(batch, block.n_pairs - k), full = padded<T>(n);
    gather_pairs(b, block, k, (n + 3) / 4 * 4, in);
    blank(b, n, full);
    form_gaps(b, full);
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
  block.power = {
      .normal_loss = sum(power[0]), .tangential = sum(power[1]), .rolling = sum(power[2])};
}

template <class Model> typename Model::template Constants<double> from_row(double const* row) {
  return load_model_constants<Model, double>(row, 1);
}

template <class Model>
void write_constants(PairMaterial const& pair, PairSize const& size, ContactChoice const& choice,
                     double* out) {
  auto const c = Model::constants(pair, size, choice);
  auto const put = [&out]<class C>(C const& part, auto n) {
    if constexpr (decltype(n)::value > 0) {
      auto const numbers = std::bit_cast<std::array<double, decltype(n)::value>>(part);
      out = std::copy(numbers.begin(), numbers.end(), out);
    }
  };
  put(c.normal, std::integral_constant<std::size_t, Model::NormalLaw::n_constants>{});
  put(c.cohesion, std::integral_constant<std::size_t, Model::CohesionLaw::n_constants>{});
  put(c.tangential, std::integral_constant<std::size_t, Model::TangentialLaw::n_constants>{});
  put(c.rolling, std::integral_constant<std::size_t, Model::RollingLaw::n_constants>{});
}

template <class Model, class T> ContactKernel<T> kernel_of() {
  using Kernel = ContactKernel<T>;
  return {
      .n_constants = Model::n_constants,
      .has_memory = Model::has_memory,
      .constants = &write_constants<Model>,
      .reach =
          [](double const* row) { return Model::NormalLaw::reach(from_row<Model>(row).normal); },
      .sweep = &sweep<Model, T>,
      .evaluate =
          [](ContactInput<double> const& in, double const* row,
             ModelSwitches<double> const& switches, ContactMemory<double> memory) {
            return Model::evaluate(in, from_row<Model>(row), switches, 0.0, memory);
          },
      .energy =
          [](double const* row, double overlap, double radius_i, double radius_j) {
            auto const c = from_row<Model>(row);
            return typename Kernel::Energy{
                Model::NormalLaw::energy(c.normal, overlap),
                Model::CohesionLaw::energy(c.cohesion, overlap, radius_i, radius_j)};
          },
      .stiffness =
          [](double const* row, double overlap) {
            auto const c = from_row<Model>(row);
            typename Kernel::Stiffness s{Model::NormalLaw::tangent(c.normal, overlap), 0.0,
                                         Model::NormalLaw::dashpot(c.normal, overlap), 0.0};
            if constexpr (Model::has_spring) {
              double const root = std::sqrt(std::max(overlap, 0.0));
              s.tangential = Model::TangentialLaw::stiffness(c.tangential, root);
              s.tangential_dashpot = Model::TangentialLaw::dashpot(c.tangential, root);
            }
            return s;
          }};
}

} // namespace dem::sweep_detail
