#include "coupling/case_checks.hpp"

#include "coupling/case_schema.hpp"
#include "coupling/press_programme.hpp"
#include "coupling/quantity.hpp"
#include "dem/contact/cohesion/linear_area.hpp"
#include "dem/expect.hpp"
#include "dem/spheres.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace coupling {

namespace {

constexpr double share_tolerance = 1e-6;
constexpr double fill_limit =
    0.40; // [1], solid fraction that random filling without overlap still reaches fast
constexpr double most_grains = 5e7; // about 50 GB at the 1 kB a grain that the engine is allowed
constexpr double step_limit = 0.05; // [1], of the smallest radius, that a tool may move in one step
constexpr double collapse_limit =
    1.0; // [1], overlap over R* at which cohesion and elasticity balance

/// `0.8` for messages: three digits say enough.
std::string brief(double value) {
  return fmt::format("{:.3g}", value);
}

/// Sections `what 1/`, `what 2/`, ... whose `key` says that they are there, in the order of the
/// Case's lists.
std::vector<std::string> present(CaseReader const& read, std::string const& what, int most,
                                 std::string const& key, std::string const& absent) {
  std::vector<std::string> sections;
  for (int number = 1; number <= most; ++number) {
    std::string const section = fmt::format("{} {}/", what, number);
    if (read.resolved().at(section + key) != absent)
      sections.push_back(section);
  }
  return sections;
}

/// What is checked together with where it was written.
class CaseCheck {
public:
  CaseCheck(Case const& checked, CaseReader const& read)
      : case_(checked), read_(read),
        components_(present(read, "Powder/Component", max_components, "Name", "")),
        stages_(present(read, "Press programme/Stage", max_stages, "Kind", "none")) {}

  void shares() const;
  void grain_sizes() const;
  void filling() const;
  void tooling() const;
  void punch_tilt() const;
  void programme() const;
  void frame() const;
  void tool_speed() const;
  void cohesion() const;
  void yielding() const;

private:
  double smallest_radius() const;
  double time_step() const;

  Case const& case_;
  CaseReader const& read_;
  std::vector<std::string> components_, stages_;
};

void CaseCheck::shares() const {
  auto const& components = case_.powder.components;
  if (components.empty())
    read_.refuse("Powder/Component 1/Name", "leaves the powder without a component. Name one?");
  double sum = 0.0;
  for (std::size_t row = 0; row < components.size(); ++row) {
    sum += components[row].mass_fraction;
    if (components[row].mass_fraction <= 0.0)
      read_.refuse(components_[row] + "Mass fraction",
                   "leaves a named component without mass. Empty its Name?");
    double sizes = 0.0;
    for (SizeClass const& size : components[row].sizes)
      sizes += size.mass_fraction;
    if (std::abs(sizes - 1.0) > share_tolerance)
      read_.refuse(
          components_[row] + "Size classes",
          fmt::format(
              "has shares that sum to {:.6g} % (all of the component is 100 %). Change one?",
              100 * sizes));
  }
  if (std::abs(sum - 1.0) > share_tolerance)
    read_.refuse(
        components_.back() + "Mass fraction",
        fmt::format(
            "makes the mass fractions sum to {:.6g} % (all of the powder is 100 %). Change one?",
            100 * sum));
}

void CaseCheck::grain_sizes() const {
  auto const& powder = case_.powder;
  double grains = 0.0;
  for (std::size_t row = 0; row < powder.components.size(); ++row) {
    Component const& component = powder.components[row];
    for (SizeClass const& size : component.sizes) {
      bool const is_added = powder.fines.share > 0.0 && size.diameter == powder.fines.diameter;
      std::string const path =
          is_added ? "Powder/Added fines/Diameter" : components_[row] + "Size classes";
      std::string const diameter = fmt::format("{} mm", brief(1e3 * size.diameter));
      double const room = std::min(case_.tooling.bore_diameter, powder.fill_height);
      bool const is_filled = powder.fill_method == FillMethod::random;
      if (size.diameter > room * (1.0 + 1e-12))
        read_.refuse(path, fmt::format("has grains of {} that do not fit (bore {} mm, fill height "
                                       "{} mm). Is the unit right?",
                                       diameter, brief(1e3 * case_.tooling.bore_diameter),
                                       brief(1e3 * powder.fill_height)));
      double const grain = component.material.density * dem::sphere_volume(size.diameter / 2);
      double const count = powder.total_mass * component.mass_fraction * size.mass_fraction / grain;
      if (is_filled && count < 0.5)
        read_.refuse(path, fmt::format("asks for {} grains of {} (one weighs {} mg). Raise the "
                                       "total mass or drop the class?",
                                       brief(count), diameter, brief(1e6 * grain)));
      grains += count;
      if (is_filled && grains > most_grains)
        read_.refuse(path, fmt::format("asks for {} grains (limit {}). Is the unit right?",
                                       brief(grains), brief(most_grains)));
    }
  }
}

void CaseCheck::filling() const {
  auto const& powder = case_.powder;
  if (case_.tooling.die_file.empty() && case_.elastic.shapes.die_file.empty() &&
      powder.fill_height > case_.tooling.die_height * (1.0 + 1e-12))
    read_.refuse("Powder/Fill height",
                 fmt::format("is above the die (Tooling/Die height = {} mm). Make the die as high?",
                             brief(1e3 * case_.tooling.die_height)));
  if (powder.fill_method != FillMethod::random)
    return;
  double solid = 0.0;
  for (Component const& component : powder.components)
    solid += powder.total_mass * component.mass_fraction / component.material.density;
  double const area = dem::pi / 4.0 * std::pow(case_.tooling.bore_diameter, 2);
  double const fraction = solid / (area * powder.fill_height);
  if (fraction <= fill_limit)
    return;
  double const height = std::ceil(1e3 * solid / (area * fill_limit)); // [mm]
  read_.refuse("Powder/Total mass",
               fmt::format("fills {} % of the cylinder with solid (random filling reaches about {} "
                           "%). Fill height and Die "
                           "height = {:.0f} mm?",
                           brief(100 * fraction), brief(100 * fill_limit), height));
}

void CaseCheck::tooling() const {
  Tooling const& tooling = case_.tooling;
  if (tooling.chordal_tolerance > tooling.bore_diameter / 20.0)
    read_.refuse(
        "Tooling/Chordal tolerance",
        fmt::format("is too coarse for the bore ({} mm). Take less than a twentieth of it?",
                    brief(1e3 * tooling.bore_diameter)));
  if (case_.elastic.coupling.mode != CouplingMode::rigid && tooling.walls == WallKind::analytic)
    read_.refuse("Tooling/Walls",
                 fmt::format("cannot deform (Mode = {} needs tools with surfaces). Set Walls = "
                             "surface, or Mode = rigid?",
                             case_.mode));
  if (tooling.walls != WallKind::analytic)
    return;
  for (std::string const name : {"Die file", "Upper punch file", "Lower punch file"})
    if (!read_.resolved().at("Tooling/" + name).empty())
      read_.refuse("Tooling/" + name,
                   "is not used (Tooling/Walls = analytic has no triangles). Set Walls = surface?");
}

void CaseCheck::punch_tilt() const {
  std::string const path = "Tooling/Punch tilt";
  double const tilt = case_.tooling.punch_tilt;
  if (tilt > 0.0 && case_.elastic.coupling.mode != CouplingMode::rigid)
    read_.refuse(path, fmt::format("is for rigid tools (the bodies of Mode = {} stand upright). "
                                   "Set Mode = rigid?",
                                   case_.mode));
  auto const refuse_contact = [&](double gap, std::string const& when) {
    if (tilt > 0.0 && gap <= 0.5 * tilt)
      read_.refuse(path, fmt::format("brings the low side of the upper punch onto the lower one "
                                     "({} the gap is {} mm). Tilt it less?",
                                     when, brief(1e3 * gap)));
  };
  refuse_contact(case_.powder.fill_height, "at the start");
  for (Stage const& stage : case_.stages)
    if (stage.kind == StageKind::move && stage.until == Limit::gap)
      refuse_contact(stage.gap, fmt::format("at the end of stage '{}'", stage.name));
}

void CaseCheck::programme() const {
  for (std::size_t row = 0; row < case_.stages.size(); ++row) {
    try {
      validate_stages(std::span(case_.stages).first(row + 1), case_.powder.fill_height);
    } catch (dem::InvalidInput const& problem) {
      read_.refuse(stages_[row] + "Kind", problem.what());
    }
  }
}

double CaseCheck::smallest_radius() const {
  double radius = std::numeric_limits<double>::infinity();
  for (Component const& component : case_.powder.components)
    for (SizeClass const& size : component.sizes)
      radius = std::min(radius, size.diameter / 2.0);
  return radius;
}

double CaseCheck::time_step() const {
  double shortest = std::numeric_limits<double>::infinity();
  for (Component const& component : case_.powder.components)
    for (SizeClass const& size : component.sizes)
      shortest = std::min(shortest, rayleigh_time(component.material, size.diameter / 2.0));
  return case_.time_stepping.rayleigh_fraction * shortest;
}

void CaseCheck::frame() const {
  FrameLaw const& frame = case_.frame;
  if (frame.seating == 0.0)
    return;
  if (frame.is_rigid())
    read_.refuse("Press frame/Seating",
                 "belongs to a frame that is rigid (Stiffness = 0). Give the stiffness?");
  if (frame.seating_force == 0.0)
    read_.refuse("Press frame/Seating force",
                 "is missing (Seating is reached on its scale). Give it?");
}

void CaseCheck::tool_speed() const {
  // The grains of a file are known only when it is read.
  if (case_.powder.fill_method != FillMethod::random)
    return;
  for (std::size_t row = 0; row < case_.stages.size(); ++row) {
    double const moved = std::abs(case_.stages[row].speed) * time_step() / smallest_radius();
    if (moved > step_limit)
      read_.refuse(stages_[row] + "Speed",
                   fmt::format("moves {} grain radii per step (limit {}). Lower the speed or the "
                               "time step?",
                               brief(moved), brief(step_limit)));
  }
}

/// Cohesion c d and elasticity 4/3 E* sqrt(R*) d^(3/2) balance at d / R* = (a k / E*)^2 with c =
/// 4/3 a k R*: a = 3 pi for sjkr2 (c = 4 pi k R*), 3/2 pi for linear_reduced (c = 2 pi k R*).
void CaseCheck::cohesion() const {
  dem::ContactChoice const& law = case_.contacts.law;
  double const k = case_.contacts.grain_grain.cohesion_energy_density;
  if (law.normal != "hertz" || (law.cohesion != "sjkr2" && law.cohesion != "linear_reduced"))
    return;
  double const factor = law.cohesion == "sjkr2" ? 3.0 * dem::pi : 1.5 * dem::pi;
  for (Component const& component : case_.powder.components) {
    double const modulus =
        dem::mix(component.material, component.material, case_.contacts.grain_grain)
            .effective_modulus;
    double const overlap = std::pow(factor * k / modulus, 2);
    if (overlap > collapse_limit)
      read_.refuse("Contact/Particle-particle/Cohesion energy density",
                   fmt::format("draws {} grains together by {} effective radii at rest (limit {}). "
                               "Is the unit right, or the "
                               "modulus too low?",
                               component.material.name, brief(overlap), brief(collapse_limit)));
  }
}

/// Beyond yield a contact resists with pi p_y R* per length of overlap, and cohesion draws with
/// C R* k: a contact that draws harder than it resists closes without end.
void CaseCheck::yielding() const {
  dem::ContactChoice const& law = case_.contacts.law;
  if (law.normal != "thornton_ning")
    return;
  double slope = 0.0; // C
  for (auto const& area : dem::LinearArea::conventions)
    if (area.name == law.cohesion)
      slope = area.at_grain;
  double const least = slope / dem::pi * case_.contacts.grain_grain.cohesion_energy_density; // [Pa]
  if (law.yield_pressure <= least)
    read_.refuse("Contact/Yield pressure",
                 fmt::format("does not hold the cohesion of {} ({} J/m^3), which needs more than "
                             "{} MPa. A stronger grain, or less cohesion?",
                             law.cohesion,
                             brief(case_.contacts.grain_grain.cohesion_energy_density),
                             brief(least * 1e-6)));
}

} // namespace

double rayleigh_time(dem::Material const& material, double radius) {
  double const shear_modulus = material.young_modulus / (2.0 * (1.0 + material.poisson_ratio));
  return dem::pi * radius * std::sqrt(material.density / shear_modulus) /
         (0.1631 * material.poisson_ratio + 0.8766);
}

void check_case(Case const& checked, CaseReader const& read) {
  CaseCheck const check(checked, read);
  check.shares();
  check.grain_sizes();
  check.filling();
  check.tooling();
  check_tool_shapes(checked, read);
  check.punch_tilt();
  check.programme();
  check.frame();
  check.tool_speed();
  check.cohesion();
  check.yielding();
}

} // namespace coupling
