#include "dem/contact/contact_store.hpp"

#include "dem/contact/list_filter.hpp"
#include "dem/expect.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace dem {

namespace {

// Skins, measured on the seed's bed: small enough that few listed pairs are idle, large enough that
// building stays under a tenth of the time.
constexpr double inner_base = 0.015, outer_base = 0.12; // of the smallest diameter
constexpr double inner_steps = 100.0,
                 outer_steps = 800.0; // how many steps ahead a moving grain is followed
constexpr double cap_diameters = 2.0; // of the smallest diameter
constexpr double least_share =
    0.5; // an inner skin below this share of its base is not worth building

// Grains a chunk of the first pass: fixed, so that its sums do not depend on the number of threads.
constexpr std::size_t chunk_rows = 1024;

struct SkinRules {
  SkinRule inner, outer;
};

SkinRules skin_rules(World const& world, double dt) {
  double const d = 2.0 * *std::ranges::min_element(world.grains.radius);
  return {.inner = {.base = inner_base * d, .horizon = inner_steps * dt, .cap = cap_diameters * d},
          .outer = {.base = outer_base * d, .horizon = outer_steps * dt, .cap = cap_diameters * d}};
}

ListAge age_now(World const& world, SkinRule const& rule) {
  ListAge age;
  age.position = world.grains.position;
  age.skin.reserve(world.grains.size());
  for (Vec3 const& v : world.grains.velocity)
    age.skin.push_back(rule.skin(v.norm()));
  for (Tool const& tool : world.tools) {
    ToolDeformation const* const deformation = tool.deformation.get();
    double const speed = tool.velocity.norm() + (deformation ? deformation->speed() : 0.0);
    age.tool.push_back(tool.displacement);
    age.tool_skin.push_back(rule.skin(speed));
    age.tool_yielded.push_back(tool.yielded);
    age.tool_extent.push_back(deformation ? deformation->extent() : 0.0);
    age.tool_present.push_back(tool.present ? 1 : 0);
  }
  return age;
}

template <class V> void permute(std::vector<V>& values, std::vector<std::uint32_t> const& order) {
  std::vector<V> sorted(values.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    sorted[k] = values[order[k]];
  values = std::move(sorted);
}

void permute_grains(Spheres& grains, std::vector<std::uint32_t> const& order) {
  permute(grains.position, order);
  permute(grains.velocity, order);
  permute(grains.spin, order);
  permute(grains.force, order);
  permute(grains.torque, order);
  permute(grains.radius, order);
  permute(grains.mass, order);
  permute(grains.material, order);
  permute(grains.id, order);
}

template <class T> MotionRecord<T> motion_of(Spheres const& g, std::size_t i) {
  Vec3 const &v = g.velocity[i], &w = g.spin[i];
  T const radius = static_cast<T>(g.radius[i]);
  return {static_cast<T>(v.x()), static_cast<T>(v.y()),
          static_cast<T>(v.z()), static_cast<T>(g.radius[i] - static_cast<double>(radius)),
          static_cast<T>(w.x()), static_cast<T>(w.y()),
          static_cast<T>(w.z()), radius};
}

} // namespace

template <class T> double TypedStore<T>::reach(World const& world) const {
  // Grows with the effective radius, so the largest grain at a tool or beside its like bounds every
  // contact.
  if (!kernel_.has_memory)
    return 0.0;
  PairTable const table(world.materials);
  Spheres const& grains = world.grains;
  auto const largest =
      static_cast<std::size_t>(std::ranges::max_element(grains.radius) - grains.radius.begin());
  double bound = 0.0;
  for (std::size_t a = 0; a < world.materials.size(); ++a)
    for (std::size_t b = 0; b < world.materials.size(); ++b) {
      double row[16] = {};
      kernel_.constants(table(static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)),
                        wall_size(grains, largest), choice_, row);
      bound = std::max(bound, kernel_.reach(row));
    }
  return bound;
}

template <class T> bool TypedStore<T>::tools_hold(World const& world) const {
  ListAge const& age = lists_.inner;
  if (age.position.size() != world.grains.size() || age.tool.size() != world.tools.size())
    return false;
  for (std::size_t t = 0; t < world.tools.size(); ++t)
    if (age.tool_way(world.tools[t], t) > age.tool_skin[t])
      return false;
  return true;
}

template <class T> bool TypedStore<T>::chunk_holds(Spheres const& grains, std::size_t chunk) const {
  ListAge const& age = lists_.inner;
  bool hold = true;
  for (std::size_t i = chunk * chunk_rows; i < std::min(grains.size(), (chunk + 1) * chunk_rows);
       ++i)
    hold &= (grains.position[i] - age.position[i]).squaredNorm() <= age.skin[i] * age.skin[i];
  return hold;
}

template <class T> bool TypedStore<T>::grains_hold(World const& world) const {
  if (lists_.inner.position.size() != world.grains.size())
    return false;
  for (std::size_t c = 0; c * chunk_rows < world.grains.size(); ++c)
    if (!chunk_holds(world.grains, c))
      return false;
  return true;
}

/// Nobody has moved since the build that was just made.
template <class T> void TypedStore<T>::start_travel() {
  auto const& skin = lists_.inner.skin;
  travel_.assign((skin.size() + chunk_rows - 1) / chunk_rows, 0.0);
  least_skin_.resize(travel_.size());
  for (std::size_t c = 0; c < travel_.size(); ++c)
    least_skin_[c] = *std::min_element(
        skin.begin() + static_cast<std::ptrdiff_t>(c * chunk_rows),
        skin.begin() + static_cast<std::ptrdiff_t>(std::min(skin.size(), (c + 1) * chunk_rows)));
}

/// A new inner list fits into the outer one if what each grain has moved already and its new skin
/// stay within the outer skin.
template <class T> bool TypedStore<T>::try_inner_build(World const& world, double dt) {
  ListAge const& outer = lists_.outer;
  if (outer.position.size() != world.grains.size() || outer.tool.size() != world.tools.size())
    return false;
  SkinRules const rules = skin_rules(world, dt);
  ListAge age = age_now(world, rules.inner);
  for (std::size_t i = 0; i < world.grains.size(); ++i) {
    double const left = outer.skin[i] - (world.grains.position[i] - outer.position[i]).norm();
    if (left < least_share * age.skin[i])
      return false;
    age.skin[i] = std::min(age.skin[i], left);
  }
  for (std::size_t t = 0; t < world.tools.size(); ++t) {
    double const left = outer.tool_skin[t] - outer.tool_way(world.tools[t], t);
    if (left < least_share * age.tool_skin[t])
      return false;
    age.tool_skin[t] = std::min(age.tool_skin[t], left);
  }
  keep_impulses();
  auto const carried = carry(lists_, {}, world.grains.size());
  lists_.inner = std::move(age);
  build_inner(world, kernel_, choice_, reach(world), carried, lists_);
  ++lists_.inner_builds;
  return true;
}

template <class T> void TypedStore<T>::full_build(World& world, double dt) {
  auto const order = order_along_curve(world.grains.position);
  std::vector<std::uint32_t> new_row(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k)
    new_row[order[k]] = k;
  permute_grains(world.grains, order);
  SkinRules const rules = skin_rules(world, dt);
  lists_.outer = age_now(world, rules.outer);
  lists_.inner = age_now(world, rules.inner);
  double const beyond = reach(world);
  build_outer(world, beyond, lists_);
  keep_impulses();
  // After the outer list, so that the largest things are not held at once.
  auto const carried = carry(lists_, new_row, world.grains.size());
  build_inner(world, kernel_, choice_, beyond, carried, lists_);
  ++lists_.outer_builds;
  ++lists_.inner_builds;
}

template <class T> double TypedStore<T>::kick_and_drift(World& world, double dt) {
  Spheres& g = world.grains;
  motions_.resize(g.size());
  std::size_t const n_chunks = (g.size() + chunk_rows - 1) / chunk_rows;
  bool const has_list = lists_.inner.position.size() == g.size();
  // After a restart nothing is known of the way so far: every chunk is measured until the next
  // build.
  if (travel_.size() != n_chunks)
    travel_.assign(n_chunks, std::numeric_limits<double>::infinity());
  least_skin_.resize(n_chunks, 0.0);
  std::vector<double> power(n_chunks, 0.0);
  bool hold = has_list;
#pragma omp parallel for schedule(static) reduction(&& : hold) if (n_chunks > 1)
  for (std::size_t c = 0; c < n_chunks; ++c) {
    double chunk_power = 0.0, square_speed = 0.0;
    for (auto i = static_cast<std::uint32_t>(c * chunk_rows);
         i < std::min(g.size(), (c + 1) * chunk_rows); ++i) {
      GrainLoad const load = is_open_ ? load_of(world, i) : GrainLoad{g.force[i], g.torque[i]};
      if (is_open_)
        half_kick(g, i, load, open_step_);
      half_kick(g, i, load, dt);
      g.position[i] += dt * g.velocity[i];
      motions_[i] = motion_of<T>(g, i);
      chunk_power += g.mass[i] * world.gravity.dot(g.velocity[i]);
      square_speed = std::max(square_speed, g.velocity[i].squaredNorm());
    }
    power[c] = chunk_power;
    // The bound on the way spares most steps from looking where each grain was at the last build.
    travel_[c] += (1.0 + 1e-9) * dt * std::sqrt(square_speed);
    if (has_list && travel_[c] > least_skin_[c])
      hold = hold && chunk_holds(g, c);
  }
  grains_hold_ = hold;
  is_open_ = false;
  double total = 0.0;
  for (double p : power)
    total += p;
  return total;
}

template <class T> void TypedStore<T>::refresh(World& world, double dt) {
  if (grains_hold_ && tools_hold(world))
    return;
  auto const begin = std::chrono::steady_clock::now();
  if (!try_inner_build(world, dt)) {
    full_build(world, dt);
    write_records(world); // the grains stand in a new order
  }
  grains_hold_ = true;
  start_travel();
  build_seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

template <class T> void TypedStore<T>::evaluate(World& world) {
  grains_hold_ = grains_hold(world);
  // Nothing is known of the step to come: look ahead as far as one of the seed's would.
  if (world.grains.size() > 0)
    refresh(world, 1e-7);
  write_records(world);
  sweep(world, 0.0);
  complete(world);
}

template <class T> void TypedStore<T>::forget(std::span<std::uint32_t const> rows) {
  std::vector<std::uint32_t> sorted(rows.begin(), rows.end());
  std::ranges::sort(sorted);
  auto const is_gone = [&](std::uint32_t row) { return std::ranges::binary_search(sorted, row); };
  for (ContactBlock<T>& block : lists_.blocks) {
    for (std::size_t k = 0; k < block.n_pairs; ++k)
      if (is_gone(block.rows[block.owner[k]]) || is_gone(block.rows[block.partner[k]]))
        block.remember(k, {});
    for (std::size_t k = 0; k < block.walls.size(); ++k)
      if (is_gone(block.walls[k].owner))
        block.remember(block.wall_offset + k, {});
  }
}

template <class T> void TypedStore<T>::write_records(World const& world) {
  motions_.resize(world.grains.size());
  for (std::size_t i = 0; i < world.grains.size(); ++i)
    motions_[i] = motion_of<T>(world.grains, i);
}

/// Own load first, then the foreign ones in the order of their blocks.
template <class T> GrainLoad TypedStore<T>::load_of(World const& world, std::uint32_t i) const {
  LoadRecord<T> const& own = lists_.own_loads[i];
  Vec3 force(own.fx, own.fy, own.fz), torque(own.tx, own.ty, own.tz);
  for (std::uint32_t h = lists_.halo_start[i]; h < lists_.halo_start[i + 1]; ++h) {
    LoadRecord<T> const& r = lists_.halo_loads[h];
    force += Vec3(r.fx, r.fy, r.fz);
    torque += Vec3(r.tx, r.ty, r.tz);
  }
  return {force + world.grains.mass[i] * world.gravity, torque};
}

template <class T> void TypedStore<T>::complete(World& world) {
  if (!is_open_)
    return;
#pragma omp parallel for schedule(static) if (lists_.blocks.size() > 1)
  for (std::size_t b = 0; b < lists_.blocks.size(); ++b)
    for (std::uint32_t i = lists_.blocks[b].first_row; i < lists_.blocks[b].end_row; ++i) {
      GrainLoad const load = load_of(world, i);
      world.grains.force[i] = load.force;
      world.grains.torque[i] = load.torque;
      half_kick(world.grains, i, load, open_step_);
    }
  is_open_ = false;
}

/// Force of the grains on each tool, and the tool's work: half the force of the last step, half of
/// this one.
template <class T> void TypedStore<T>::tally_tools(World& world, double dt) const {
  std::vector<Vec3> force(world.tools.size(), Vec3::Zero());
  std::vector<double> radial(world.tools.size(), 0.0);
  for (ContactBlock<T> const& block : lists_.blocks)
    for (std::size_t k = 0; k < block.walls.size(); ++k) {
      WallContact const& wall = block.walls[k];
      Vec3 const f(wall.fx, wall.fy, wall.fz);
      if (!block.yields.empty())
        world.tools[wall.tool].yield_work += dt * f.dot(block.yields[k].motion.velocity);
      force[wall.tool] -= f;
      double const r = std::sqrt(wall.px * wall.px + wall.py * wall.py);
      if (r > 0.0)
        radial[wall.tool] -= (f.x() * wall.px + f.y() * wall.py) / r;
    }
  for (std::size_t t = 0; t < world.tools.size(); ++t) {
    Tool& tool = world.tools[t];
    tool.work -= 0.5 * dt * (tool.force + force[t]).dot(tool.velocity);
    tool.force = force[t];
    tool.radial_force = radial[t];
  }
}

template <class T> void TypedStore<T>::sweep(World& world, double dt) {
  crowding_.form(world, lists_, choice_.multi_contact);
  SweepInput<T> const input{
      .grains = world.grains,
      .motions = motions_.data(),
      .own_loads = lists_.own_loads.data(),
      .halo_loads = lists_.halo_loads.data(),
      .tools = world.tools,
      .switches = {.cohesion_in_limit = choice_.friction_limit == "net" ? T(1) : T(0),
                   .clip = choice_.clip_attractive_damping ? T(1) : T(0),
                   .viscous_time = static_cast<T>(choice_.viscous_time)},
      .dt = dt,
      .window_time = world.window_time,
      .crowding = crowding_.data()};
// Static: a block stays with its thread, and its contacts in that core's cache.
#pragma omp parallel for schedule(static) if (lists_.blocks.size() > 1)
  for (std::size_t b = 0; b < lists_.blocks.size(); ++b)
    kernel_.sweep(lists_.blocks[b], input);
  open_step_ = dt;
  is_open_ = true;
  tally_tools(world, dt);
  for (ContactBlock<T> const& block : lists_.blocks) {
    world.energy.normal_damping += dt * block.power.normal_loss;
    world.energy.tangential_work += dt * block.power.tangential;
    world.energy.rolling_work += dt * block.power.rolling;
    if (dt > 0.0)
      world.energy.plastic_work += block.power.plastic_work;
  }
}

template class TypedStore<float>;
template class TypedStore<double>;

} // namespace dem
