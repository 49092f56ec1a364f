#include "dem/contact/list_filter.hpp"

#include "dem/contact/wall_yield.hpp"
#include "dem/expect.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace dem {

namespace {

constexpr std::size_t max_constants = 16;

/// Appends one contact's constants and memory to the block's streams once their length is known.
template <class T> class StreamWriter {
public:
  StreamWriter(ContactKernel<T> const& kernel, ContactBlock<T>& block)
      : kernel_(kernel), block_(block) {}

  void write(std::size_t at, PairMaterial const& pair, PairSize const& size,
             ContactChoice const& choice) {
    std::array<double, max_constants> row{};
    kernel_.constants(pair, size, choice, row.data());
    for (int s = 0; s < kernel_.n_constants; ++s)
      block_.constants[ContactBlock<T>::entry(at, s, kernel_.n_constants)] =
          static_cast<T>(row[static_cast<std::size_t>(s)]);
  }

  void remember(std::size_t at, std::span<CarriedContact<T> const> carried, std::uint32_t partner,
                std::uint32_t patch) {
    for (auto const& c : carried) {
      if (c.partner != partner || c.patch != patch)
        continue;
      block_.remember(at, c.memory);
      return;
    }
  }

private:
  ContactKernel<T> const& kernel_;
  ContactBlock<T>& block_;
};

/// A pair of the inner list by rows, on its way to slots.
struct RowPair {
  std::uint32_t owner, partner;
};

template <class T>
std::vector<RowPair> list_pairs(World const& world, double reach, ContactLists<T> const& lists,
                                ContactBlock<T> const& block) {
  auto const& x = lists.inner.position;
  auto const& skin = lists.inner.skin;
  std::vector<RowPair> pairs;
  for (std::uint32_t i = block.first_row; i < block.end_row; ++i) {
    double const own = world.grains.radius[i] + skin[i] + reach;
    for (std::uint32_t j : lists.pairs.of(i)) {
      double const sum = own + world.grains.radius[j] + skin[j];
      if ((x[i] - x[j]).squaredNorm() < sum * sum)
        pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// Gives every grain of the block's contacts a slot: its own grains in their order, then the
/// foreign partners. Slots are short numbers, because the sweep is bound by what it reads; they are
/// padded for the gather stage.
template <class T> void number_slots(std::vector<RowPair> const& pairs, ContactBlock<T>& block) {
  block.rows.resize(block.n_rows());
  std::iota(block.rows.begin(), block.rows.end(), block.first_row);
  for (RowPair const& pair : pairs)
    if (pair.partner >= block.end_row)
      block.rows.push_back(pair.partner);
  auto const halo = block.rows.begin() + block.n_rows();
  std::sort(halo, block.rows.end());
  block.rows.erase(std::unique(halo, block.rows.end()), block.rows.end());
  // A block of 512 grains has some hundred foreign partners; only a giant grain among dust could
  // have more than fit.
  VALIDATE(block.rows.size() <= 65536,
           "a grain touches more than 65536 others (the sizes of this powder differ too "
           "much for one block of contacts). Are the diameters right?");
  block.n_pairs = static_cast<std::uint32_t>(pairs.size());
  std::size_t const full = (pairs.size() + 3u) / 4u * 4u;
  block.owner.assign(full, 0);
  block.partner.assign(full, 0);
  auto const begin = block.rows.begin() + block.n_rows();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    std::uint32_t const j = pairs[k].partner;
    block.owner[k] = static_cast<std::uint16_t>(pairs[k].owner - block.first_row);
    block.partner[k] = static_cast<std::uint16_t>(
        j < block.end_row ? j - block.first_row
                          : std::lower_bound(begin, block.rows.end(), j) - block.rows.begin());
  }
}

/// A patch may be followed without search while neither grain nor tool can bring the closest point
/// to its rim.
bool stays_inside(Tool const& tool, SurfacePoint const& at, double radius, double travel) {
  PatchKind const kind = tool.surface.patches()[at.patch].kind;
  if (kind == PatchKind::curved || at.distance < 0.0 || at.distance > 2.0 * radius + travel)
    return false;
  return tool.surface.distance_to_rim(at.patch, at.point) > 2.0 * travel + 1e-3 * radius;
}

template <class T>
void list_walls(World const& world, double reach, ContactLists<T> const& lists,
                ContactBlock<T>& block) {
  block.walls.clear();
  block.yields.clear();
  bool const deforms = any_deforms(world.tools);
  std::vector<SurfacePoint> found;
  for (std::uint32_t i = block.first_row; i < block.end_row; ++i) {
    double const radius = world.grains.radius[i];
    for (std::uint32_t s = lists.near_tool_start[i]; s < lists.near_tool_start[i + 1]; ++s) {
      auto const [t, patch] = lists.near_tool[s];
      Tool const& tool = world.tools[t];
      // As it was then: a restart builds this list again after the tool may have gone.
      if (lists.inner.tool_present[t] == 0)
        continue;
      double const travel =
          lists.inner.skin[i] + lists.inner.tool_skin[t] + lists.inner.tool_extent[t];
      Vec3 const centre = lists.inner.position[i] - lists.inner.tool[t];
      bool const is_sure = patch != NearTool::searched;
      found.clear();
      if (is_sure)
        found.push_back(tool.surface.on_patch(patch, centre));
      else
        tool.surface.find(centre, radius + travel + reach, found);
      for (SurfacePoint const& at : found) {
        if (at.distance > radius + travel + reach)
          continue;
        block.walls.push_back({.owner = i,
                               .tool = t,
                               .patch = at.patch,
                               .inside_rim = is_sure || stays_inside(tool, at, radius, travel),
                               .px = 0,
                               .py = 0,
                               .pz = 0,
                               .fx = 0,
                               .fy = 0,
                               .fz = 0,
                               .normal_force = 0});
        if (deforms)
          block.yields.push_back(yield_at(tool, at.patch, at.point));
      }
    }
  }
}

} // namespace

PairSize pair_size(Spheres const& grains, std::size_t i, std::size_t j) {
  return {.effective_radius =
              grains.radius[i] * grains.radius[j] / (grains.radius[i] + grains.radius[j]),
          .effective_mass = grains.mass[i] * grains.mass[j] / (grains.mass[i] + grains.mass[j]),
          .is_wall = false};
}

PairSize wall_size(Spheres const& grains, std::size_t i) {
  return {.effective_radius = grains.radius[i], .effective_mass = grains.mass[i], .is_wall = true};
}

std::vector<NearTool> tools_near(World const& world, ListAge const& age, std::size_t i,
                                 double reach) {
  std::vector<NearTool> near;
  std::vector<SurfacePoint> found;
  double const radius = world.grains.radius[i];
  for (std::uint32_t t = 0; t < world.tools.size(); ++t) {
    Tool const& tool = world.tools[t];
    if (age.tool_present[t] == 0)
      continue;
    double const travel = age.skin[i] + age.tool_skin[t] + age.tool_extent[t];
    found.clear();
    tool.surface.find(age.position[i] - age.tool[t], radius + travel + reach, found);
    if (found.empty())
      continue;
    bool const is_sure = found.size() == 1 && stays_inside(tool, found[0], radius, travel);
    near.push_back({t, is_sure ? found[0].patch : NearTool::searched});
  }
  return near;
}

template <class T>
void fill_block(World const& world, ContactKernel<T> const& kernel, ContactChoice const& choice,
                PairTable const& table, double reach, CarriedContacts<T> const& carried,
                ContactLists<T> const& lists, ContactBlock<T>& block) {
  EXPECT(kernel.n_constants <= static_cast<int>(max_constants));
  Spheres const& grains = world.grains;
  auto const pairs = list_pairs(world, reach, lists, block);
  number_slots(pairs, block);
  list_walls(world, reach, lists, block);
  block.wall_offset = padded<T>(block.n_pairs);
  std::size_t const full = block.wall_offset + padded<T>(block.walls.size());
  block.n_memory = kernel.has_memory ? 4 : 3;
  // Padding lanes keep a harmless 1 as every constant: they are computed and thrown away.
  block.constants.assign(full * static_cast<std::size_t>(kernel.n_constants), T(1));
  block.memory.assign(full * static_cast<std::size_t>(block.n_memory), T(0));

  StreamWriter<T> stream(kernel, block);
  for (std::size_t k = 0; k < block.n_pairs; ++k) {
    auto const [i, j] = pairs[k];
    stream.write(k, table(grains.material[i], grains.material[j]), pair_size(grains, i, j), choice);
    stream.remember(k, carried.of(i), j, CarriedContacts<T>::between_grains);
  }
  for (std::size_t k = 0; k < block.walls.size(); ++k) {
    WallContact const& wall = block.walls[k];
    std::size_t const at = block.wall_offset + k;
    stream.write(at, table(grains.material[wall.owner], world.tools[wall.tool].material),
                 wall_size(grains, wall.owner), choice);
    stream.remember(at, carried.of(wall.owner), wall.tool, wall.patch);
  }
}

template void fill_block(World const&, ContactKernel<float> const&, ContactChoice const&,
                         PairTable const&, double, CarriedContacts<float> const&,
                         ContactLists<float> const&, ContactBlock<float>&);
template void fill_block(World const&, ContactKernel<double> const&, ContactChoice const&,
                         PairTable const&, double, CarriedContacts<double> const&,
                         ContactLists<double> const&, ContactBlock<double>&);

} // namespace dem
