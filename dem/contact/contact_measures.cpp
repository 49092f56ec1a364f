#include "dem/contact/contact_store.hpp"

#include "dem/contact/list_filter.hpp"
#include "dem/contact/stable_step.hpp"
#include "dem/expect.hpp"

#include <algorithm>
#include <cmath>

/// What is asked of the contacts between steps: listing, energies, the stable step. All of it in
/// full precision and one contact at a time.
namespace dem {

namespace {

Triple<double> triple(Vec3 const& v) {
  return {v.x(), v.y(), v.z()};
}
Vec3 vec3(Triple<double> const& v) {
  return {v.x, v.y, v.z};
}

ContactInput<double> pair_input(Spheres const& g, std::size_t i, std::size_t j) {
  Vec3 const separation = g.position[i] - g.position[j];
  double const sum = g.radius[i] + g.radius[j];
  return {.separation = triple(separation),
          .square_gap = sum * sum - separation.squaredNorm(),
          .radius_sum = sum,
          .radius_i = g.radius[i],
          .radius_j = g.radius[j],
          .velocity = triple(g.velocity[i] - g.velocity[j]),
          .spin_i = triple(g.spin[i]),
          .spin_j = triple(g.spin[j])};
}

ContactInput<double> wall_input(Spheres const& g, Vec3 const& tool_velocity, std::size_t i,
                                SurfacePoint const& at) {
  double const sum = 2.0 * g.radius[i], r = g.radius[i] + at.distance;
  return {.separation = triple(r * at.normal),
          .square_gap = (sum - r) * (sum + r),
          .radius_sum = sum,
          .radius_i = g.radius[i],
          .radius_j = g.radius[i],
          .velocity = triple(g.velocity[i] - tool_velocity),
          .spin_i = triple(g.spin[i]),
          .spin_j = {0.0, 0.0, 0.0}};
}

double overlap_of(ContactInput<double> const& in) {
  return in.square_gap / (in.radius_sum + vec3(in.separation).norm());
}

double effective_radius(ContactInput<double> const& in, Contact const& c) {
  return c.j == Contact::none ? in.radius_i : in.radius_i * in.radius_j / in.radius_sum;
}

bool touches(ContactInput<double> const& in, ContactMemory<double> const& memory) {
  return in.square_gap > 0.0 || memory.normal >= 0.5;
}

/// Area A = pi R* d with which a contact displaces volume [m^2].
double displacing_area(Spheres const& g, LinearContact const& c) {
  bool const is_pair = c.j != LinearContact::wall;
  double const overlap = 2.0 * (g.radius[c.i] - c.lever_i);
  return pi * overlap * (is_pair ? pair_size(g, c.i, c.j) : wall_size(g, c.i)).effective_radius;
}

/// Contacts of one grain stiffen each other by  d F_c / d d_e = b K / V A_c A_e.  Each gets the sum
/// of its row, which bounds what they do together.
void add_crowding(Spheres const& g, CrowdingField<double> const& crowding,
                  std::vector<LinearContact>& contacts) {
  std::vector<double> area(g.size(), 0.0);
  auto const for_each_grain = [](LinearContact const& c, auto&& visit) {
    visit(c.i);
    if (c.j != LinearContact::wall)
      visit(c.j);
  };
  for (LinearContact const& c : contacts)
    for_each_grain(c, [&](std::size_t i) { area[i] += displacing_area(g, c); });
  for (LinearContact& c : contacts) {
    double const own = displacing_area(g, c);
    for_each_grain(c, [&](std::size_t i) {
      c.normal_stiffness += crowding[i].per_volume * own * (area[i] - own);
    });
  }
}

} // namespace

/// Calls visit(Contact, input, constants, memory) for every listed contact of a block; only what is
/// cheap is set in the Contact.
template <class T>
template <class Visit>
void TypedStore<T>::for_each_contact(World const& world, PairTable const& table,
                                     CrowdingField<double> const& crowding,
                                     ContactBlock<T> const& block, Visit&& visit) const {
  Spheres const& g = world.grains;
  double constants[16] = {};
  auto const memory_at = [&block](std::size_t at) {
    auto const m = block.remembered(at);
    return ContactMemory<double>{.spring = {m[0], m[1], m[2]}, .normal = m[3]};
  };
  for (std::size_t k = 0; k < block.n_pairs; ++k) {
    std::uint32_t const i = block.rows[block.owner[k]], j = block.rows[block.partner[k]];
    Contact c{};
    c.i = i, c.j = j, c.tool = c.patch = c.triangle = Contact::none;
    kernel_.constants(table(g.material[i], g.material[j]), pair_size(g, i, j), choice_, constants);
    auto input = pair_input(g, i, j);
    if (!crowding.is_empty())
      input.crowding =
          crowding_force(pair_size(g, i, j).effective_radius, std::max(overlap_of(input), 0.0),
                         crowding[i].pressure + crowding[j].pressure,
                         crowding[i].per_volume + crowding[j].per_volume);
    visit(c, input, constants, memory_at(k));
  }
  std::vector<SurfacePoint> found;
  for (std::size_t k = 0; k < block.walls.size(); ++k) {
    WallContact const& wall = block.walls[k];
    Tool const& tool = world.tools[wall.tool];
    if (!tool.present)
      continue;
    found.clear();
    auto const motion = block.yields.empty() ? ToolDeformation::Motion{} : block.yields[k].motion;
    Vec3 const shift =
        tool.displacement + motion.displacement + world.window_time * motion.velocity;
    Vec3 const centre = g.position[wall.owner] - shift;
    if (wall.inside_rim) {
      found.push_back(tool.surface.on_patch(wall.patch, centre));
    } else {
      tool.surface.find(centre, 1.2 * g.radius[wall.owner], found);
      std::erase_if(found, [&](SurfacePoint const& at) { return at.patch != wall.patch; });
    }
    if (found.empty())
      continue;
    Contact c{};
    c.i = wall.owner, c.j = Contact::none, c.tool = wall.tool, c.patch = wall.patch;
    c.triangle = found.front().triangle;
    c.point = found.front().point + shift;
    kernel_.constants(table(g.material[wall.owner], tool.material), wall_size(g, wall.owner),
                      choice_, constants);
    auto input = wall_input(g, tool.velocity + motion.velocity, wall.owner, found.front());
    if (!crowding.is_empty())
      input.crowding =
          crowding_force(g.radius[wall.owner], std::max(overlap_of(input), 0.0),
                         crowding[wall.owner].pressure, crowding[wall.owner].per_volume);
    visit(c, input, constants, memory_at(block.wall_offset + k));
  }
}

/// Runs over the blocks [first, end) in parallel, each with a result of its own, and hands the
/// results back in block order.
template <class T>
template <class Result, class Visit>
std::vector<Result>
TypedStore<T>::per_block(World const& world, CrowdingField<double> const& crowding,
                         std::size_t first, std::size_t end, Visit&& visit) const {
  std::vector<Result> results(end - first);
  PairTable const table(world.materials);
#pragma omp parallel for schedule(dynamic, 1) if (results.size() > 1)
  for (std::size_t b = 0; b < results.size(); ++b)
    for_each_contact(
        world, table, crowding, lists_.blocks[first + b],
        [&](Contact const& c, ContactInput<double> const& in, double const* constants,
            ContactMemory<double> const& memory) { visit(results[b], c, in, constants, memory); });
  return results;
}

template <class T>
void TypedStore<T>::visit(World const& world, ContactStream::Visit const& look) const {
  // So many blocks at once keep some threads busy and the memory small.
  constexpr std::size_t at_once = 4;
  ModelSwitches<double> const switches{.cohesion_in_limit =
                                           choice_.friction_limit == "net" ? 1.0 : 0.0,
                                       .clip = choice_.clip_attractive_damping ? 1.0 : 0.0,
                                       .viscous_time = choice_.viscous_time};
  auto const complete = [&](std::vector<Contact>& part, Contact c, ContactInput<double> const& in,
                            double const* constants, ContactMemory<double> const& memory) {
    ContactOutput<double> const out = kernel_.evaluate(in, constants, switches, memory);
    if (out.overlap <= 0.0 && memory.normal < 0.5)
      return;
    c.normal = vec3(in.separation).normalized();
    c.overlap = out.overlap;
    c.normal_force = out.normal_force;
    c.cohesive_force = out.cohesive_force;
    c.force = vec3(out.force);
    c.tangential_force = c.force - out.normal_force * c.normal;
    if (c.tool == Contact::none)
      c.point = world.grains.position[c.i] - (in.radius_i - 0.5 * out.overlap) * c.normal;
    else if (c.triangle == Contact::none)
      c.triangle = world.tools[c.tool].surface.triangle_at(
          c.patch, c.point - world.tools[c.tool].displacement);
    part.push_back(c);
  };
  std::size_t const n_blocks = lists_.blocks.size();
  auto const crowding = crowding_now(world);
  for (std::size_t first = 0; first < n_blocks; first += at_once)
    for (auto const& part : per_block<std::vector<Contact>>(
             world, crowding, first, std::min(first + at_once, n_blocks), complete))
      for (Contact const& contact : part)
        look(contact);
}

template <class T> CrowdingField<double> TypedStore<T>::crowding_now(World const& world) const {
  CrowdingField<double> crowding;
  crowding.form(world, lists_, choice_.multi_contact);
  return crowding;
}

template <class T> StoredEnergy TypedStore<T>::energy(World const& world) const {
  auto const crowding = crowding_now(world);
  // Half of S^2 a grain, less half of v^2 a contact and grain: see multi_contact.hpp.
  auto const alone = [&](Contact const& c, double effective_radius, double overlap) {
    if (crowding.is_empty())
      return 0.0;
    double const volume = displaced_volume(effective_radius, overlap);
    double const per_volume =
        crowding[c.i].per_volume + (c.j == Contact::none ? 0.0 : crowding[c.j].per_volume);
    return 0.5 * per_volume * volume * volume;
  };
  auto const parts = per_block<StoredEnergy>(
      world, crowding, 0, lists_.blocks.size(),
      [&](StoredEnergy& part, Contact const& c, ContactInput<double> const& in,
          double const* constants, ContactMemory<double> const& memory) {
        if (!touches(in, memory))
          return;
        double const overlap = overlap_of(in);
        auto const e = kernel_.energy(constants, overlap, memory.normal, in.radius_i, in.radius_j);
        part.elastic += e.elastic - alone(c, effective_radius(in, c), std::max(overlap, 0.0));
        part.cohesive += e.cohesive;
      });
  StoredEnergy total;
  if (!crowding.is_empty())
    for (std::size_t i = 0; i < world.grains.size(); ++i)
      total.elastic += 0.5 * crowding[i].pressure * crowding[i].pressure / crowding[i].per_volume;
  for (StoredEnergy const& part : parts)
    total.elastic += part.elastic, total.cohesive += part.cohesive;
  return total;
}

template <class T> double TypedStore<T>::stable_step(World const& world) const {
  auto const crowding = crowding_now(world);
  auto const parts = per_block<std::vector<LinearContact>>(
      world, crowding, 0, lists_.blocks.size(),
      [&](std::vector<LinearContact>& part, Contact const& c, ContactInput<double> const& in,
          double const* constants, ContactMemory<double> const& memory) {
        Vec3 const separation = vec3(in.separation);
        double const overlap = overlap_of(in);
        if (overlap <= 0.0)
          return;
        auto const s = kernel_.stiffness(constants, overlap, memory.normal);
        part.push_back({.i = c.i,
                        .j = c.j,
                        .normal = separation.normalized(),
                        .lever_i = in.radius_i - 0.5 * overlap,
                        .lever_j = in.radius_j - 0.5 * overlap,
                        .normal_stiffness = s.normal + in.crowding / overlap,
                        .tangential_stiffness = s.tangential,
                        .normal_dashpot = s.normal_dashpot + choice_.viscous_time * s.normal,
                        .tangential_dashpot = s.tangential_dashpot});
      });
  std::vector<LinearContact> contacts;
  for (auto const& part : parts)
    contacts.insert(contacts.end(), part.begin(), part.end());
  if (!crowding.is_empty())
    add_crowding(world.grains, crowding, contacts);
  return dem::stable_step(world.grains, contacts);
}

template <class T> ListStatistics TypedStore<T>::statistics(World const& world) const {
  ListStatistics s{.outer_builds = lists_.outer_builds,
                   .inner_builds = lists_.inner_builds,
                   .seconds = build_seconds_};
  for (auto const n : per_block<std::uint64_t>(
           world, {}, 0, lists_.blocks.size(),
           [&](std::uint64_t&part, Contact const&, ContactInput<double> const&in, double const*,
               ContactMemory<double> const&memory) { part += touches(in, memory); }))
    s.active += n;
  auto const bytes = [](auto const&... v) { return ((v.capacity() * sizeof(v[0])) + ...); };
  for (ContactBlock<T> const& b : lists_.blocks) {
    s.listed += b.n_pairs + b.walls.size();
    s.bytes += bytes(b.owner, b.partner, b.walls, b.rows, b.constants, b.memory, b.halo_place);
  }
  for (ListAge const* age : {&lists_.outer, &lists_.inner})
    s.bytes += bytes(age->position, age->skin);
  s.bytes += crowding_.bytes();
  s.bytes +=
      bytes(lists_.pairs.start, lists_.pairs.partner, lists_.near_tool_start, lists_.near_tool,
            lists_.halo_start, lists_.own_loads, lists_.halo_loads, motions_);
  return s;
}

template void TypedStore<float>::visit(World const&, ContactStream::Visit const&) const;
template void TypedStore<double>::visit(World const&, ContactStream::Visit const&) const;
template StoredEnergy TypedStore<float>::energy(World const&) const;
template StoredEnergy TypedStore<double>::energy(World const&) const;
template double TypedStore<float>::stable_step(World const&) const;
template double TypedStore<double>::stable_step(World const&) const;
template ListStatistics TypedStore<float>::statistics(World const&) const;
template ListStatistics TypedStore<double>::statistics(World const&) const;

} // namespace dem
