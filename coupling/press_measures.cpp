#include "coupling/press_measures.hpp"

#include "dem/contact/contact.hpp"
#include "dem/measure/compact.hpp"
#include "dem/measure/contact_statistics.hpp"
#include "dem/measure/core.hpp"
#include "dem/measure/energy.hpp"
#include "dem/measure/shape.hpp"

#include <algorithm>
#include <cmath>

namespace coupling {
namespace {

double floor_of(Press const& press) {
  return tool_named(press.world, "lower_punch").displacement.z() + press.programme.faces().lower;
}

/// Grains that are wholly outside the die (below its rim), or wholly behind a punch, of the tools
/// that are present.
double count_outside(Press const& press) {
  dem::Spheres const& grains = press.world.grains;
  double const bore = 0.5 * press.setup.tooling.bore_diameter;
  dem::Tool const& die = tool_named(press.world, "die");
  dem::Tool const& upper = tool_named(press.world, "upper_punch");
  dem::Tool const& lower = tool_named(press.world, "lower_punch");
  if (!die.present)
    return 0.0; // on the open punch a grain may roll off
  double const top = upper.displacement.z() + press.programme.faces().upper;
  double const slope = press.setup.tooling.punch_slope();
  double const bottom = floor_of(press);
  double const rim = die.displacement.z() + rim_height(die);
  auto const is_outside = [&](std::size_t i) {
    dem::Vec3 const& x = grains.position[i];
    double const R = grains.radius[i];
    double const r = std::hypot(x.x() - die.displacement.x(), x.y() - die.displacement.y());
    return (r > bore + R && x.z() < rim) || (lower.present && x.z() < bottom - R) ||
           (upper.present && x.z() > top + slope * x.x() + R);
  };
  double n = 0.0;
  for (std::size_t i = 0; i < grains.size(); ++i)
    n += is_outside(i) ? 1.0 : 0.0;
  return n;
}

/// Mean radial pressure on the bore where grains stand against it.
double radial_pressure(Press const& press, double bed_height, double compact_height) {
  dem::Tool const& die = tool_named(press.world, "die");
  double const in_die = die.displacement.z() + rim_height(die) - floor_of(press);
  double const height = std::min({bed_height, compact_height, in_die});
  double const area = dem::pi * press.setup.tooling.bore_diameter * height;
  return die.present && area > 0.0 ? die.radial_force / area : 0.0;
}

double inertia_force(dem::Spheres const& grains) {
  double force = 0.0;
  for (dem::Vec3 const& f : grains.force)
    force += f.z();
  return force;
}

void read_energies(Press const& press, Reading& r) {
  dem::World const& world = press.world;
  auto const stored = world.contacts.energy(world);
  r.kinetic_energy = dem::kinetic_energy(world.grains).total();
  r.elastic_energy = stored.elastic;
  r.cohesive_energy = stored.cohesive;
  for (dem::Tool const& tool : world.tools)
    r.tool_work += tool.work + tool.yield_work;
  r.gravity_work = world.energy.gravity_work;
  r.normal_damping_loss = world.energy.normal_damping;
  r.plastic_loss = world.energy.plastic_work;
  r.tangential_work = world.energy.tangential_work;
  r.rolling_loss = world.energy.rolling_work;
  r.released_energy = press.tally.released_energy;
  r.breakage_loss = press.tally.breakage_loss;
  r.broken_grains = static_cast<double>(press.tally.broken_grains);
  r.dust_mass = press.tally.dust_mass;
  r.frame_energy = press.setup.frame.energy(r.upper_punch_force);
  double const found =
      r.kinetic_energy + r.elastic_energy + r.cohesive_energy - press.tally.start_energy;
  double const put_in = r.tool_work + r.gravity_work;
  double const gone = r.normal_damping_loss + r.plastic_loss + r.tangential_work + r.rolling_loss +
                      r.released_energy + r.breakage_loss;
  r.energy_error = found - (put_in - gone);
}

void read_forces(Press const& press, Reading& r) {
  r.upper_punch_force = squeezing_force(tool_named(press.world, "upper_punch"));
  r.upper_punch_reading = press.load_cell.reading();
  r.lower_punch_force = squeezing_force(tool_named(press.world, "lower_punch"));
  r.wall_axial_force = squeezing_force(tool_named(press.world, "die"));
  double const weight = -press.grain_mass * press.world.gravity.z();
  r.axial_imbalance = r.upper_punch_force - r.lower_punch_force - r.wall_axial_force + weight +
                      inertia_force(press.world.grains);
}

/// Deformable tools, in the order of the press; nothing of rigid ones.
void read_deformation(Press const& press, Reading& r) {
  ToolCoupling const& coupling = press.coupling;
  if (coupling.is_rigid())
    return;
  r.bore_growth = coupling.retreat(0, press.world);
  r.upper_punch_retreat = coupling.retreat(1, press.world);
  r.lower_punch_retreat = coupling.retreat(2, press.world);
  r.tool_energy = coupling.energy(press.world);
  if (coupling.choice().mode != CouplingMode::one_way)
    r.bed_height += r.upper_punch_retreat + r.lower_punch_retreat;
}

/// Dust lies in the pores, as much beside every grain:  1 - (1 - p) (1 + V_dust / V_grains).
double filled_with_dust(Press const& press, double porosity) {
  if (press.tally.dust_volume == 0.0)
    return porosity;
  double volume = 0.0;
  for (double const radius : press.world.grains.radius)
    volume += dem::sphere_volume(radius);
  return 1.0 - (1.0 - porosity) * (1.0 + press.tally.dust_volume / volume);
}

} // namespace

std::vector<PressRecord::Column> curve_columns() {
  return {{"time", "s"},
          {"punch_gap", "m"},
          {"bed_height", "m"},
          {"upper_punch_force", "N"},
          {"upper_punch_reading", "N"},
          {"lower_punch_force", "N"},
          {"wall_axial_force", "N"},
          {"wall_radial_pressure", "Pa"},
          {"compact_height", "m"},
          {"mean_overlap", "m"},
          {"max_relative_overlap", "1"},
          {"coordination", "1"},
          {"grains_outside", "1"},
          {"kinetic_energy", "J"},
          {"elastic_energy", "J"},
          {"cohesive_energy", "J"},
          {"tool_work", "J"},
          {"gravity_work", "J"},
          {"normal_damping_loss", "J"},
          {"plastic_loss", "J"},
          {"tangential_work", "J"},
          {"rolling_loss", "J"},
          {"released_energy", "J"},
          {"breakage_loss", "J"},
          {"broken_grains", "1"},
          {"dust_mass", "kg"},
          {"frame_energy", "J"},
          {"tool_energy", "J"},
          {"upper_punch_retreat", "m"},
          {"lower_punch_retreat", "m"},
          {"bore_growth", "m"},
          {"energy_error", "J"},
          {"axial_imbalance", "N"}};
}

std::vector<double> row_of(Reading const& r) {
  return {r.time,
          r.punch_gap,
          r.bed_height,
          r.upper_punch_force,
          r.upper_punch_reading,
          r.lower_punch_force,
          r.wall_axial_force,
          r.wall_radial_pressure,
          r.compact_height,
          r.mean_overlap,
          r.max_relative_overlap,
          r.coordination,
          r.grains_outside,
          r.kinetic_energy,
          r.elastic_energy,
          r.cohesive_energy,
          r.tool_work,
          r.gravity_work,
          r.normal_damping_loss,
          r.plastic_loss,
          r.tangential_work,
          r.rolling_loss,
          r.released_energy,
          r.breakage_loss,
          r.broken_grains,
          r.dust_mass,
          r.frame_energy,
          r.tool_energy,
          r.upper_punch_retreat,
          r.lower_punch_retreat,
          r.bore_growth,
          r.energy_error,
          r.axial_imbalance};
}

Reading read_press(Press const& press) {
  dem::World const& world = press.world;
  auto const statistics = dem::measure_contacts(world.grains, dem::ContactStream(world));
  Reading r;
  r.time = world.time;
  r.punch_gap = press.programme.commanded_gap(world);
  r.bed_height = punch_gap(world, press.programme.faces());
  read_deformation(press, r);
  r.compact_height = dem::compact_extent(world.grains, floor_of(press)).height();
  r.mean_overlap = statistics.mean_overlap;
  r.max_relative_overlap =
      std::max(statistics.max_relative_overlap, statistics.max_relative_tool_overlap);
  r.coordination = statistics.coordination;
  r.grains_outside = count_outside(press);
  r.wall_radial_pressure = radial_pressure(press, r.bed_height, r.compact_height);
  read_forces(press, r);
  read_energies(press, r);
  return r;
}

double total_energy(dem::World const& world) {
  auto const stored = world.contacts.energy(world);
  return dem::kinetic_energy(world.grains).total() + stored.elastic + stored.cohesive;
}

double axial_force_on_grains(Press const& press) {
  double force = press.grain_mass * press.world.gravity.z();
  for (dem::Tool const& tool : press.world.tools)
    if (tool.present)
      force -= tool.force.z();
  return force;
}

double axial_momentum(dem::World const& world) {
  return dem::momentum(world.grains).z();
}

void measure_compact(Press& press) {
  dem::Spheres const& grains = press.world.grains;
  dem::ContactStream const contacts(press.world);
  double const bore = 0.5 * press.setup.tooling.bore_diameter;
  double const floor = floor_of(press);
  auto const seed = dem::seed_porosity(grains, contacts, bore, floor);
  press.tally.porosity = filled_with_dust(press, seed.porosity);
  press.tally.compact_height = seed.height;
  auto const core = dem::find_core(grains, press.setup.output.core_diameter_fraction * bore, floor);
  press.tally.porosity_core = filled_with_dust(press, dem::core_porosity(grains, contacts, core));
}

void measure_released_shape(Press& press) {
  press.tally.released_shape = dem::compact_shape(press.world.grains, floor_of(press));
}

void measure_final_shape(Press& press) {
  if (press.tally.released_shape.empty())
    return;
  auto const shape = dem::compact_shape(press.world.grains, floor_of(press));
  press.tally.shape_similarity = dem::shape_similarity(press.tally.released_shape, shape);
  press.tally.shape_quality =
      static_cast<std::uint64_t>(dem::shape_quality(press.tally.shape_similarity));
}

} // namespace coupling
