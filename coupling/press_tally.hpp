#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace coupling {

/// What a run keeps count of between its records. All of it is restored on a restart.
struct PressTally {
  static constexpr double not_reached = std::numeric_limits<double>::quiet_NaN();

  double max_force = 0.0;              ///< [N], on the upper punch, over every step
  double recorded_force = 0.0;         ///< [N], the largest in a record
  double seen_peak = 0.0;              ///< [N], max_force at the newest record
  double ejection_force = not_reached; ///< [N], largest on the lower punch in stages until flush
  double smallest_gap = std::numeric_limits<double>::infinity();  ///< [m]
  double smallest_step = std::numeric_limits<double>::infinity(); ///< [s]
  double max_relative_overlap = 0.0;                              ///< [1], over the records
  double step_to_collision = 0.0; ///< [1], largest ratio of the step to the Hertz collision time
  double step_to_stable = 0.0;    ///< [1], largest ratio of the step to its bound

  // Momentum along the press axis.
  double start_momentum = 0.0;    ///< [N s]
  double axial_impulse = 0.0;     ///< [N s], of tools and gravity so far
  double throughput = 0.0;        ///< [N s], of the upper punch alone: the scale of the error
  double axial_force = 0.0;       ///< [N], of tools and gravity on the grains, last step
  double momentum_error = 0.0;    ///< [N s], largest
  double imbalance_at_peak = 0.0; ///< [N], of the recorded axial forces where the force is largest

  // Energy.
  double start_energy = 0.0;    ///< [J], kinetic and stored
  double released_energy = 0.0; ///< [J], stored in contacts with tools when these were removed
  double breakage_loss = 0.0;   ///< [J], that went with broken grains
  double peak_work = 0.0;       ///< [J], largest so far that tools and gravity did
  double energy_error = 0.0;    ///< [J], largest size so far

  // Grains that broke, and what of them is no grain any more.
  std::uint64_t broken_grains = 0;
  double dust_mass = 0.0;   ///< [kg]
  double dust_volume = 0.0; ///< [m^3]

  double max_outside = 0.0; ///< grains outside the tools while the die is present

  // The compact at the end of unloading, and its shape when the die is released and later.
  double porosity = not_reached;
  double porosity_core = not_reached;
  double compact_height = not_reached; ///< [m]
  std::vector<double> released_shape;  ///< see dem/measure; empty: not released yet
  double shape_similarity = not_reached;
  std::uint64_t shape_quality = 0; ///< 1 to 5

  std::uint64_t n_records = 0;   ///< made at the record interval
  std::uint64_t n_snapshots = 0; ///< made at the snapshot interval
  double last_record = -1.0;     ///< [s], time of the newest record
  double last_snapshot = -1.0;   ///< [s], time of the newest snapshot
  double last_stress = 0.0;      ///< [s], time of the newest files of the tools' stress
  double wall_seconds = 0.0;     ///< [s], of clock; the only field that differs between equal runs

  template <class Field> void visit_state(Field&& field);
};

template <class Field> void PressTally::visit_state(Field&& field) {
  field("tally/max_force", max_force);
  field("tally/recorded_force", recorded_force);
  field("tally/seen_peak", seen_peak);
  field("tally/ejection_force", ejection_force);
  field("tally/smallest_gap", smallest_gap);
  field("tally/smallest_step", smallest_step);
  field("tally/max_relative_overlap", max_relative_overlap);
  field("tally/step_to_collision", step_to_collision);
  field("tally/step_to_stable", step_to_stable);
  field("tally/start_momentum", start_momentum);
  field("tally/axial_impulse", axial_impulse);
  field("tally/throughput", throughput);
  field("tally/axial_force", axial_force);
  field("tally/momentum_error", momentum_error);
  field("tally/imbalance_at_peak", imbalance_at_peak);
  field("tally/start_energy", start_energy);
  field("tally/released_energy", released_energy);
  field("tally/breakage_loss", breakage_loss);
  field("tally/broken_grains", broken_grains);
  field("tally/dust_mass", dust_mass);
  field("tally/dust_volume", dust_volume);
  field("tally/peak_work", peak_work);
  field("tally/energy_error", energy_error);
  field("tally/max_outside", max_outside);
  field("tally/porosity", porosity);
  field("tally/porosity_core", porosity_core);
  field("tally/compact_height", compact_height);
  field("tally/released_shape", released_shape);
  field("tally/shape_similarity", shape_similarity);
  field("tally/shape_quality", shape_quality);
  field("tally/n_records", n_records);
  field("tally/n_snapshots", n_snapshots);
  field("tally/last_record", last_record);
  field("tally/last_snapshot", last_snapshot);
  field("tally/last_stress", last_stress);
  field("tally/wall_seconds", wall_seconds);
}

} // namespace coupling
