#pragma once

#include "dem/contact/contact_block.hpp"
#include "dem/contact/contact_kernel.hpp"
#include "dem/contact/crowding.hpp"
#include "dem/contact/lanes.hpp"
#include "dem/contact/wall_meeting.hpp"

#include <algorithm>

/// The two outer stages of the sweep: gather (records of both grains into arrays) and scatter
/// (forces into the buffer of the block's slots).
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
  T crowding[batch] = {}; ///< [N], by other contacts of the two grains; stays 0 where they are off
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
    double const radius = in.grains.radius[wall.owner];
    MotionRecord<T> const& motion = in.motions[wall.owner];
    auto const [distance, normal, point, velocity] =
        meet_wall(in.tools[wall.tool], wall, yields ? yields + k : nullptr, in.window_time,
                  in.grains.position[wall.owner], radius, found);
    wall.px = point.x(), wall.py = point.y(), wall.pz = point.z();
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
        b.radius_rest[k] = b.crowding[k] = T(0);
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

/// How far the contact's own gap closes: the overlap, or 0.
template <class T> T closed_gap(Batch<T> const& b, std::size_t k) {
  T const r = std::sqrt(b.sx[k] * b.sx[k] + b.sy[k] * b.sy[k] + b.sz[k] * b.sz[k]);
  return std::max(b.square_gap[k] / (b.radius_sum[k] + r), T(0));
}

template <class T>
void crowd_pairs(Batch<T>& b, ContactBlock<T> const& block, std::size_t first, std::size_t n,
                 Crowding<T> const* crowding) {
  for (std::size_t k = 0; k < n; ++k) {
    Crowding<T> const& i = crowding[block.rows[block.owner[first + k]]];
    Crowding<T> const& j = crowding[block.rows[block.partner[first + k]]];
    T const effective_radius = b.radius_i[k] * b.radius_j[k] / (b.radius_i[k] + b.radius_j[k]);
    b.crowding[k] = crowding_force(effective_radius, closed_gap(b, k), i.pressure + j.pressure,
                                   i.per_volume + j.per_volume);
  }
}

template <class T>
void crowd_walls(Batch<T>& b, WallContact const* walls, std::size_t n,
                 Crowding<T> const* crowding) {
  for (std::size_t k = 0; k < n; ++k) {
    auto const& [pressure, per_volume] = crowding[walls[k].owner];
    b.crowding[k] = crowding_force(b.radius_i[k], closed_gap(b, k), pressure, per_volume);
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

} // namespace dem::sweep_detail
