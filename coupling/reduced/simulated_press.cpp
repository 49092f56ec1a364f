#include "coupling/reduced/simulated_press.hpp"

#include "coupling/case_file.hpp"
#include "coupling/record/atomic_file.hpp"
#include "coupling/record/curves.hpp"
#include "coupling/record/run_file.hpp"
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
  double volume, mass; ///< [m^3], [kg]
};
Solid solid_of(fs::path const& folder, Powder const& powder) {
  auto const file = folder / "run.h5";
  if (!fs::exists(file))
    return {.volume = powder.total_mass * specific_volume(powder), .mass = powder.total_mass};
  Solid solid{};
  auto const grains = read_grains(file);
  for (std::size_t k = 0; k < grains.size(); ++k)
    solid.volume += dem::sphere_volume(grains.radius[k]), solid.mass += grains.mass[k];
  return solid;
}

/// E of the component that most of the powder is.
double young_modulus_of(Powder const& powder) {
  return std::ranges::max_element(powder.components, {}, &Component::mass_fraction)
      ->material.young_modulus;
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
  auto const file = run_folder / "case.resolved.prm";
  VALIDATE(fs::exists(file), fmt::format("{}: is not there (a simulation is a run folder). Is the "
                                         "name right?",
                                         file.string()));
  Case const setup = parse_case(read_file(file), file);
  auto const solid = solid_of(run_folder, setup.powder);
  double const bore = setup.tooling.bore_diameter;
  Bed const bed{.solid_area = solid.volume / area_of(bore), .bore = bore};
  auto fit = fit_bed_law(cycle_of(read_curves(run_folder / "curves.csv")), bed);
  Press nominal{.pressed = {.law = fit.law, .bed = bed},
                .machine = {.frame = setup.frame, .load_cell = setup.load_cell},
                .solid_density = solid.mass / solid.volume};
  return {.nominal = std::move(nominal),
          .sheet = {.young_modulus = young_modulus_of(setup.powder),
                    .cohesion = setup.contacts.grain_grain.cohesion_energy_density},
          .fit = std::move(fit)};
}

Press in_laboratory(SimulatedPress const& simulated, measured::Sample const& sample) {
  Press press = simulated.nominal;
  auto& bed = press.pressed.bed;
  double const bore = sample.die_diameter.value;
  bed = {.solid_area = sample.mass.value / press.solid_density / area_of(bore), .bore = bore};
  return press;
}

} // namespace coupling::reduced
