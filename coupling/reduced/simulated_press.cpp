#include "coupling/reduced/simulated_press.hpp"

#include "coupling/case_file.hpp"
#include "coupling/record/atomic_file.hpp"
#include "coupling/record/curves.hpp"
#include "coupling/record/run_file.hpp"
#include "coupling/reduced/mean_cycle.hpp"
#include "dem/expect.hpp"
#include "dem/vec3.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace coupling::reduced {
namespace {

namespace fs = std::filesystem;

double area_of(double bore) {
  return 0.25 * dem::pi * bore * bore;
}

/// Solid of the grains as they were made, which are whole grains.
struct Solid {
  double volume, mass;      ///< [m^3], [kg]
  std::size_t n_grains = 0; ///< 0: not known
};
Solid solid_of(fs::path const& folder, Powder const& powder) {
  auto const file = folder / "run.h5";
  if (!fs::exists(file))
    return {.volume = powder.total_mass * specific_volume(powder), .mass = powder.total_mass};
  Solid solid{};
  auto const grains = read_grains(file);
  solid.n_grains = grains.size();
  for (std::size_t k = 0; k < grains.size(); ++k)
    solid.volume += dem::sphere_volume(grains.radius[k]), solid.mass += grains.mass[k];
  return solid;
}

/// E of the component that most of the powder is.
double young_modulus_of(Powder const& powder) {
  return std::ranges::max_element(powder.components, {}, &Component::mass_fraction)
      ->material.young_modulus;
}

Case case_of(fs::path const& run_folder) {
  auto const file = run_folder / "case.resolved.prm";
  VALIDATE(fs::exists(file), fmt::format("{}: is not there (a simulation is a run folder). Is the "
                                         "name right?",
                                         file.string()));
  return parse_case(read_file(file), file);
}

/// Packings of one case differ by their seed alone; what a bed's law hangs on is looked at.
void refuse_other_case(Case const& first, Case const& other) {
  auto const refuse = [&](char const* what, double a, double b) {
    VALIDATE(a == b, fmt::format("{}: has the {} {:g}, and {} has {:g} (packings of one case are "
                                 "asked for). Is one of another case?",
                                 other.file.string(), what, b, first.file.string(), a));
  };
  refuse("Young's modulus [Pa]", young_modulus_of(first.powder), young_modulus_of(other.powder));
  refuse("cohesion energy density [J/m^3]", first.contacts.grain_grain.cohesion_energy_density,
         other.contacts.grain_grain.cohesion_energy_density);
  refuse("friction between grains", first.contacts.grain_grain.static_friction,
         other.contacts.grain_grain.static_friction);
  refuse("friction on the tools", first.contacts.grain_wall.static_friction,
         other.contacts.grain_wall.static_friction);
  refuse("mass [kg]", first.powder.total_mass, other.powder.total_mass);
  refuse("bore [m]", first.tooling.bore_diameter, other.tooling.bore_diameter);
}

} // namespace

double specific_volume(Powder const& powder) {
  double volume = 0.0;
  for (auto const& component : powder.components)
    volume += component.mass_fraction / component.material.density;
  return volume;
}

std::string in_words(BedFit const& fit) {
  return fmt::format(
      "the emulator stands for its simulation within {:.2g} % of the largest force in loading and "
      "{:.2g} % in unloading (r.m.s. of the upper punch; {} and {} records; K = {:.4g} Pa, S = "
      "{:.4g} Pa, onset {:.4f}, exponent {:.3f}, recovery {:.3f}, wall friction {:.3f}, radial "
      "ratio {:.3f})",
      100.0 * fit.loading_upper.rms, 100.0 * fit.unloading_upper.rms, fit.n_loading,
      fit.n_unloading, fit.law.stiffness, fit.law.cohesion, fit.law.onset, fit.law.exponent,
      fit.law.recovery, fit.law.wall_friction, fit.law.radial_ratio);
}

SimulatedPress simulated_press(fs::path const& run_folder) {
  return simulated_press(std::vector{run_folder});
}

SimulatedPress simulated_press(std::vector<fs::path> const& run_folders) {
  VALIDATE(!run_folders.empty(), "simulation: no run folder is given. Which one stands for it?");
  std::vector<SimulatedCycle> cycles;
  Solid mean{};
  auto const n = static_cast<double>(run_folders.size());
  auto const setup = case_of(run_folders.front());
  for (auto const& folder : run_folders) {
    refuse_other_case(setup, case_of(folder));
    auto const solid = solid_of(folder, setup.powder);
    mean.volume += solid.volume / n, mean.mass += solid.mass / n;
    mean.n_grains = solid.n_grains;
    cycles.push_back(cycle_of(read_curves(folder / "curves.csv")));
  }
  double const bore = setup.tooling.bore_diameter;
  Bed const bed{.solid_area = mean.volume / area_of(bore), .bore = bore};
  auto fit = fit_bed_law(mean_cycle(cycles), bed);
  Press nominal{.pressed = {.law = fit.law, .bed = bed},
                .machine = {.frame = setup.frame, .load_cell = setup.load_cell},
                .solid_density = mean.mass / mean.volume};
  return {.nominal = std::move(nominal),
          .sheet = {.young_modulus = young_modulus_of(setup.powder),
                    .cohesion = setup.contacts.grain_grain.cohesion_energy_density},
          .fit = std::move(fit),
          .n_grains = mean.n_grains,
          .n_packings = run_folders.size()};
}

Press in_laboratory(SimulatedPress const& simulated, measured::Sample const& sample) {
  Press press = simulated.nominal;
  auto& bed = press.pressed.bed;
  double const bore = sample.die_diameter.value;
  bed = {.solid_area = sample.mass.value / press.solid_density / area_of(bore), .bore = bore};
  return press;
}

} // namespace coupling::reduced
