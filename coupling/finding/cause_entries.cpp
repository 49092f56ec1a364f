#include "coupling/finding/cause_entries.hpp"

#include "coupling/case_schema.hpp"
#include "coupling/finding/dosed_entries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

namespace coupling::finding {
namespace {

/// A cause with the case and the facts that its entries are made from.
struct Asked {
  FoundCause const& cause;
  Case const& setup;
  BedFacts const& facts;

  double size() const { return cause.size(); }
  /// A parameter of the cause's law, NaN if it has none of that name.
  double parameter(std::string_view name) const {
    auto const at = std::ranges::find(cause.parameters, name, &CauseParameter::name);
    return at == cause.parameters.end() ? not_known : at->value;
  }
};

CauseEntries obstacle(std::string sentence) {
  return {.obstacle = std::move(sentence)};
}

CauseEntries change(std::string const& path, double value) {
  return {.changes = {entry_change(path, value)}};
}

/// Every component has its own Young's modulus; absent components have none.
CauseEntries scaled_modulus(Case const& setup, double factor) {
  CauseEntries entries;
  std::size_t next = 0;
  for (int number = 1; number <= max_components && next < setup.powder.components.size();
       ++number) {
    std::string const at = fmt::format("Powder/Component {}/", number);
    // The resolved case names the components that it has; their numbers may have holes.
    if (setup.resolved_text.find(fmt::format("subsection Component {}\n", number)) ==
        std::string::npos)
      continue;
    double const modulus = setup.powder.components[next++].material.young_modulus;
    entries.changes.push_back(entry_change(at + "Young's modulus", factor * modulus));
  }
  return entries;
}

CauseEntries scaled_cohesion(Case const& setup, double factor) {
  if (setup.contacts.law.cohesion == "none")
    return obstacle("the case's Cohesion law is none. Choose a law and calibrate it first?");
  CauseEntries entries;
  for (auto const& [section, pair] :
       {std::pair("Contact/Particle-particle/", setup.contacts.grain_grain),
        std::pair("Contact/Particle-wall/", setup.contacts.grain_wall)})
    if (pair.cohesion_energy_density > 0.0)
      entries.changes.push_back(entry_change(std::string(section) + "Cohesion energy density",
                                             factor * pair.cohesion_energy_density));
  if (entries.changes.empty())
    return obstacle("the case has no cohesion that could be scaled. Set a Cohesion energy density "
                    "first?");
  return entries;
}

CauseEntries frame_entries_of(Asked const& asked) {
  double const own = asked.setup.frame.stiffness;
  double const compliance = (own > 0.0 ? 1.0 / own : 0.0) + asked.size();
  if (!(compliance > 0.0))
    return obstacle("the frame would be stiffer than rigid. Is the case's own Stiffness too low?");
  auto entries = change("Press frame/Stiffness", 1.0 / compliance);
  double const seating = asked.parameter("seating"), force = asked.parameter("seating_force");
  if (seating > 0.0 && force > 0.0) {
    entries.changes.push_back(entry_change("Press frame/Seating", seating));
    entries.changes.push_back(entry_change("Press frame/Seating force", force));
  }
  return entries;
}

CauseEntries rate_entries_of(Asked const& asked) {
  std::string const path = "Contact/Viscous time";
  if (double const given = asked.parameter("viscous_time"); given > 0.0)
    return change(path, given);
  if (!(asked.facts.growth_time > 0.0))
    return obstacle("how fast the force grows at full load is not known, from which the Viscous "
                    "time follows. Run the case first?");
  return change(path,
                asked.setup.contacts.law.viscous_time + asked.size() * asked.facts.growth_time);
}

CauseEntries die_entries_of(Asked const& asked) {
  auto const& tooling = asked.setup.tooling;
  double const inner = 0.5 * tooling.bore_diameter, outer = inner + tooling.wall_thickness;
  auto const& steel = asked.setup.elastic.material;
  double const ring =
      (outer * outer + inner * inner) / (outer * outer - inner * inner) + steel.poisson_ratio;
  bool const is_rigid = asked.setup.mode == "rigid";
  double const compliance =
      (is_rigid ? 0.0 : 1.0 / steel.young_modulus) + asked.size() / (tooling.bore_diameter * ring);
  if (!(compliance > 0.0))
    return obstacle("the die would be stiffer than rigid. Is its own Young's modulus too low?");
  auto entries = change("Deformable tools/Young's modulus", 1.0 / compliance);
  if (is_rigid)
    entries.changes.insert(entries.changes.begin(), {"Mode", "two_way_secant"});
  return entries;
}

CauseEntries entries_of(DosedCause const& dosed, FoundCause const& cause, BedFacts const& facts) {
  if (!dosed.obstacle.empty())
    return obstacle(dosed.obstacle);
  auto const shown = facts.doses.find(cause.name);
  return shown == facts.doses.end()
             ? CauseEntries{.changes = dosed.entries(dosed.dose.guess),
                            .remark = "a first guess, which no simulation has tried"}
             : CauseEntries{.changes = dosed.entries(shown->second.dose),
                            .remark = shown->second.remark};
}

using EntriesOf = std::function<CauseEntries(Asked const&)>;

/// An entry to which the size is added.
EntriesOf added(std::string path, std::function<double(Case const&)> own) {
  return [path = std::move(path), own = std::move(own)](Asked const& asked) {
    return change(path, own(asked.setup) + asked.size());
  };
}

/// An entry that grows by the size's share of itself.
EntriesOf scaled(std::string path, std::function<double(Case const&)> own) {
  return [path = std::move(path), own = std::move(own)](Asked const& asked) {
    return change(path, own(asked.setup) * (1.0 + asked.size()));
  };
}

/// A new block of the simulator is a line here.
std::map<std::string, EntriesOf, std::less<>> const& table() {
  std::string const friction = "Coefficient of static friction";
  static std::map<std::string, EntriesOf, std::less<>> const all = {
      {"frame_compliance", frame_entries_of},
      {"gap_offset",
       added("Press frame/Gap offset", [](Case const& c) { return c.frame.gap_offset; })},
      {"thermal_drift",
       added("Press frame/Thermal drift", [](Case const& c) { return c.frame.thermal_drift; })},
      {"force_gain", scaled("Load cell/Gain", [](Case const& c) { return c.load_cell.gain; })},
      {"force_offset", added("Load cell/Offset", [](Case const& c) { return c.load_cell.offset; })},
      {"force_lag",
       added("Load cell/Time constant", [](Case const& c) { return c.load_cell.lag; })},
      {"mass_error",
       scaled("Powder/Total mass", [](Case const& c) { return c.powder.total_mass; })},
      {"die_size",
       added("Tooling/Bore diameter", [](Case const& c) { return c.tooling.bore_diameter; })},
      {"wall_friction", added("Contact/Particle-wall/" + friction,
                              [](Case const& c) { return c.contacts.grain_wall.static_friction; })},
      {"particle_friction",
       added("Contact/Particle-particle/" + friction,
             [](Case const& c) { return c.contacts.grain_grain.static_friction; })},
      {"young_modulus",
       [](Asked const& asked) { return scaled_modulus(asked.setup, 1.0 + asked.size()); }},
      {"cohesion",
       [](Asked const& asked) { return scaled_cohesion(asked.setup, 1.0 + asked.size()); }},
      {"rate_dependence", rate_entries_of},
      {"die_compliance", die_entries_of},
      {"punch_tilt",
       added("Tooling/Punch tilt", [](Case const& c) { return c.tooling.punch_tilt; })},
  };
  return all;
}

} // namespace

EntryChange entry_change(std::string const& path, double value) {
  return {path, print_quantity(value, find_entry(path)->physical)};
}

CauseEntries case_entries_of(FoundCause const& cause, Case const& setup, BedFacts const& facts) {
  if (!std::isfinite(cause.size()))
    return obstacle("its size is not known");
  if (auto const dosed = dosed_cause(cause, setup, facts))
    return entries_of(*dosed, cause, facts);
  auto const found = table().find(cause.name);
  if (found == table().end())
    return obstacle("no entry of a case is known for it");
  return found->second({cause, setup, facts});
}

CauseEntries case_entries_of(CalibratedValue const& value, Case const& setup) {
  auto const factor = [&](double own) {
    return value.unit == "1" ? value.value : value.value / own;
  };
  if (value.name == "young_modulus")
    return scaled_modulus(setup, factor(setup.powder.components.front().material.young_modulus));
  if (value.name == "cohesion" || value.name == "cohesion_energy_density") {
    double const own = setup.contacts.grain_grain.cohesion_energy_density;
    if (!(own > 0.0) && value.unit != "1" && setup.contacts.law.cohesion != "none")
      return change("Contact/Particle-particle/Cohesion energy density", value.value);
    return scaled_cohesion(setup, factor(own));
  }
  if (value.name == "springback" || value.name == "solid_density")
    return obstacle("it is a number of the measured compact, which a case does not set");
  return obstacle("no entry of a case is known for it");
}

} // namespace coupling::finding
