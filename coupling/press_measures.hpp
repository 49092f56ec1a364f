#pragma once

#include "coupling/press.hpp"

#include <vector>

/// What is read off a press: the rows of curves.csv and the numbers of summary.json.
///
/// Signs. Upper punch force: positive when the bed pushes the punch up; lower punch and die:
/// positive when pushed down. So, with the weight W of the grains and their inertia dP/dt along z,
/// F_upper + W + dP/dt = F_lower + F_wall.
namespace coupling {

/// One row of curves.csv with what else is seen at that moment.
struct Reading {
  double time = 0.0;                 ///< [s]
  double punch_gap = 0.0;            ///< [m], as the machine commands it
  double bed_height = 0.0;           ///< [m], between the punch faces as they are
  double upper_punch_force = 0.0;    ///< [N]
  double upper_punch_reading = 0.0;  ///< [N], what its load cell shows
  double lower_punch_force = 0.0;    ///< [N]
  double wall_axial_force = 0.0;     ///< [N]
  double wall_radial_pressure = 0.0; ///< [Pa], radial force / area of the bore that the bed covers
  double compact_height = 0.0;       ///< [m], highest minus lowest grain surface
  double mean_overlap = 0.0;         ///< [m], over contacts of grains with grains
  double max_relative_overlap = 0.0; ///< [1], of the smaller radius, tools included
  double coordination = 0.0;         ///< [1], contacts of a grain with grains, mean
  double grains_outside = 0.0;       ///< grains wholly outside the die or behind a punch
  double kinetic_energy = 0.0;       ///< [J], spin included
  double elastic_energy = 0.0;       ///< [J], stored in normal contacts
  double cohesive_energy = 0.0;      ///< [J], <= 0
  double tool_work = 0.0;            ///< [J], done by the tools on the grains
  double gravity_work = 0.0;         ///< [J]
  double normal_damping_loss = 0.0;  ///< [J]
  double plastic_loss = 0.0;         ///< [J]
  double tangential_work = 0.0;      ///< [J], into springs, dashpots and sliding
  double rolling_loss = 0.0;         ///< [J]
  double released_energy = 0.0;      ///< [J], that went with removed tools
  double breakage_loss = 0.0;        ///< [J], that contacts, motion and dust of broken grains held
  double broken_grains = 0.0;        ///< so far
  double dust_mass = 0.0;            ///< [kg], of them; in no grain any more
  double frame_energy = 0.0;         ///< [J], in the press frame, beside the grains' ledger
  double tool_energy = 0.0;          ///< [J], stored in deformable tools, likewise
  double upper_punch_retreat = 0.0;  ///< [m], mean shortening of the punch at its face
  double lower_punch_retreat = 0.0;  ///< [m]
  double bore_growth = 0.0;          ///< [m], of the bore's radius, mean over the bore
  double energy_error = 0.0;         ///< [J], energy found - energy accounted for
  double axial_imbalance = 0.0;      ///< [N], F_upper - F_lower - F_wall + W + dP/dt
};

/// Columns of curves.csv, in the order of `row_of`.
std::vector<PressRecord::Column> curve_columns();
std::vector<double> row_of(Reading const& reading);

/// Reads the press. Energies are relative to the start as PressTally holds it.
Reading read_press(Press const& press);

/// Kinetic and stored energy of the present state [J].
double total_energy(dem::World const& world);

/// Axial force of tools and gravity on all grains, and their momentum along z.
double axial_force_on_grains(Press const& press); ///< [N]
double axial_momentum(dem::World const& world);   ///< [N s]

/// Takes porosities and height of the compact into the tally: at the end of a stage.
void measure_compact(Press& press);

/// Takes the compact's shape when the die has been released, and compares it with that later.
void measure_released_shape(Press& press);
void measure_final_shape(Press& press);

/// The numbers of summary.json as far as the run has come, with its checks.
Summary summarise(Press const& press);

} // namespace coupling
