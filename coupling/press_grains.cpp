#include "coupling/press_grains.hpp"

#include "coupling/record/h5.hpp"
#include "coupling/record/restart_file.hpp"
#include "dem/expect.hpp"
#include "dem/packing/fill.hpp"
#include "dem/packing/packing_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace coupling {
namespace {

std::vector<dem::PackingComponent> packing_components(Powder const& powder) {
  std::vector<dem::PackingComponent> components;
  for (Component const& component : powder.components)
    components.push_back({.name = component.material.name,
                          .density = component.material.density,
                          .material = static_cast<std::uint8_t>(components.size())});
  return components;
}

dem::Packing fill_at_random(Case const& setup) {
  std::vector<dem::GrainShare> shares;
  std::uint8_t row = 0;
  for (Component const& component : setup.powder.components) {
    for (SizeClass const& size : component.sizes)
      shares.push_back({.diameter = size.diameter,
                        .density = component.material.density,
                        .material = row,
                        .component = row,
                        .mass_fraction = component.mass_fraction * size.mass_fraction});
    ++row;
  }
  // Facets stand inside the bore by up to the chordal tolerance.
  double const sagitta =
      setup.tooling.walls == WallKind::surface ? setup.tooling.chordal_tolerance : 0.0;
  // Where the punch stands lower than the machine takes it to stand, there is less room.
  double const height = setup.powder.fill_height + std::min(setup.frame.gap_offset, 0.0) -
                        0.5 * setup.tooling.punch_tilt;
  return dem::fill_cylinder(
      dem::count_grains(shares, setup.powder.total_mass),
      {.radius = 0.5 * setup.tooling.bore_diameter, .height = height, .wall_clearance = sagitta},
      setup.powder.seed);
}

/// The grains of a state file, in the order of their ids.
dem::Packing read_state(std::filesystem::path const& source, std::size_t n_components) {
  auto const file = std::filesystem::is_directory(source) ? newest_restart(source).file : source;
  StateReader const whole(file);
  H5Reader const state(file);
  auto const position = state.get<std::vector<dem::Vec3>>("state/grains/position");
  auto const velocity = state.get<std::vector<dem::Vec3>>("state/grains/velocity");
  auto const spin = state.get<std::vector<dem::Vec3>>("state/grains/spin");
  auto const radius = state.get<std::vector<double>>("state/grains/radius");
  auto const material = state.get<std::vector<std::uint8_t>>("state/grains/material");
  auto const id = state.get<std::vector<std::uint32_t>>("state/grains/id");
  auto const components = static_cast<std::size_t>(*std::ranges::max_element(material)) + 1;
  VALIDATE(components <= n_components, fmt::format("{}: its grains are of {} components, the case "
                                                   "has {}. Is it the state of another powder?",
                                                   file.string(), components, n_components));
  dem::Packing packing(id.size());
  for (std::size_t row = 0; row < id.size(); ++row)
    packing[id[row]] = {.position = position[row],
                        .diameter = 2.0 * radius[row],
                        .component = material[row],
                        .velocity = velocity[row],
                        .spin = spin[row]};
  return packing;
}

} // namespace

dem::MaterialTable make_materials(Case const& setup, double friction) {
  dem::MaterialTable materials;
  for (Component const& component : setup.powder.components)
    materials.add(component.material);
  auto const wall = materials.add(setup.tooling.material);
  for (std::uint8_t i = 0; i <= wall; ++i)
    for (std::uint8_t j = 0; j <= i; ++j) {
      auto interaction = i == wall ? setup.contacts.grain_wall : setup.contacts.grain_grain;
      interaction.static_friction *= friction;
      materials.set_interaction(i, j, interaction);
    }
  return materials;
}

std::uint8_t tool_material(Case const& setup) {
  return static_cast<std::uint8_t>(setup.powder.components.size());
}

dem::Spheres fill_die(Case const& setup) {
  auto const components = packing_components(setup.powder);
  switch (setup.powder.fill_method) {
  case FillMethod::random:
    return dem::make_spheres(fill_at_random(setup), components);
  case FillMethod::file:
    return dem::make_spheres(dem::read_packing(setup.powder.fill_file, components), components);
  case FillMethod::state:
    return dem::make_spheres(read_state(setup.powder.fill_file, components.size()), components);
  }
  throw dem::ContractViolation("a way of filling without a branch");
}

} // namespace coupling
