#pragma once

#include "coupling/case.hpp"

#include <gtest/gtest.h>

/// Field by field, to the last bit; `file` and `resolved_text` say where a case came from, not what
/// it is.
namespace coupling {

inline void expect_equal(dem::Material const& a, dem::Material const& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.density, b.density);
  EXPECT_EQ(a.young_modulus, b.young_modulus);
  EXPECT_EQ(a.poisson_ratio, b.poisson_ratio);
}

inline void expect_equal(Powder const& a, Powder const& b) {
  ASSERT_EQ(a.components.size(), b.components.size());
  for (std::size_t i = 0; i < a.components.size(); ++i) {
    expect_equal(a.components[i].material, b.components[i].material);
    EXPECT_EQ(a.components[i].mass_fraction, b.components[i].mass_fraction);
    ASSERT_EQ(a.components[i].sizes.size(), b.components[i].sizes.size());
    for (std::size_t k = 0; k < a.components[i].sizes.size(); ++k) {
      EXPECT_EQ(a.components[i].sizes[k].diameter, b.components[i].sizes[k].diameter);
      EXPECT_EQ(a.components[i].sizes[k].mass_fraction, b.components[i].sizes[k].mass_fraction);
    }
  }
  EXPECT_EQ(a.total_mass, b.total_mass);
  EXPECT_EQ(a.fill_method, b.fill_method);
  EXPECT_EQ(a.fill_file, b.fill_file);
  EXPECT_EQ(a.fill_height, b.fill_height);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.settle_time, b.settle_time);
  EXPECT_EQ(a.fill_state, b.fill_state);
  EXPECT_EQ(a.fines.share, b.fines.share);
  EXPECT_EQ(a.fines.diameter, b.fines.diameter);
}

inline void expect_equal(dem::ContactChoice const& a, dem::ContactChoice const& b) {
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.cohesion, b.cohesion);
  EXPECT_EQ(a.tangential, b.tangential);
  EXPECT_EQ(a.rolling, b.rolling);
  EXPECT_EQ(a.friction_limit, b.friction_limit);
  EXPECT_EQ(a.tangential_damping, b.tangential_damping);
  EXPECT_EQ(a.clip_attractive_damping, b.clip_attractive_damping);
  EXPECT_EQ(a.characteristic_velocity, b.characteristic_velocity);
  EXPECT_EQ(a.yield_pressure, b.yield_pressure);
  EXPECT_EQ(a.plasticity_ratio, b.plasticity_ratio);
  EXPECT_EQ(a.adhesion_exponent, b.adhesion_exponent);
  EXPECT_EQ(a.viscous_time, b.viscous_time);
  EXPECT_EQ(a.multi_contact, b.multi_contact);
  EXPECT_EQ(a.precision, b.precision);
}

inline void expect_equal(dem::Interaction const& a, dem::Interaction const& b) {
  EXPECT_EQ(a.restitution, b.restitution);
  EXPECT_EQ(a.static_friction, b.static_friction);
  EXPECT_EQ(a.rolling_friction, b.rolling_friction);
  EXPECT_EQ(a.cohesion_energy_density, b.cohesion_energy_density);
  EXPECT_EQ(a.surface_energy, b.surface_energy);
}

inline void expect_equal(Tooling const& a, Tooling const& b) {
  EXPECT_EQ(a.walls, b.walls);
  EXPECT_EQ(a.bore_diameter, b.bore_diameter);
  EXPECT_EQ(a.die_height, b.die_height);
  EXPECT_EQ(a.wall_thickness, b.wall_thickness);
  EXPECT_EQ(a.punch_length, b.punch_length);
  EXPECT_EQ(a.punch_tilt, b.punch_tilt);
  EXPECT_EQ(a.chordal_tolerance, b.chordal_tolerance);
  EXPECT_EQ(a.die_file, b.die_file);
  EXPECT_EQ(a.upper_punch_file, b.upper_punch_file);
  EXPECT_EQ(a.lower_punch_file, b.lower_punch_file);
  EXPECT_EQ(a.stl_scale, b.stl_scale);
  expect_equal(a.material, b.material);
}

inline void expect_equal(Stage const& a, Stage const& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.tools, b.tools);
  EXPECT_EQ(a.speed, b.speed);
  EXPECT_EQ(a.until, b.until);
  EXPECT_EQ(a.duration, b.duration);
  EXPECT_EQ(a.gap, b.gap);
  EXPECT_EQ(a.force, b.force);
  EXPECT_EQ(a.servo, b.servo);
  EXPECT_EQ(a.follow_file, b.follow_file);
  EXPECT_EQ(a.time_scale, b.time_scale);
}

inline void expect_equal(TimeStepping const& a, TimeStepping const& b) {
  EXPECT_EQ(a.rayleigh_fraction, b.rayleigh_fraction);
  EXPECT_EQ(a.adaptive, b.adaptive);
  EXPECT_EQ(a.safety, b.safety);
  EXPECT_EQ(a.max_relative_overlap, b.max_relative_overlap);
  EXPECT_EQ(a.max_energy_error, b.max_energy_error);
}

inline void expect_equal(Output const& a, Output const& b) {
  EXPECT_EQ(a.record_interval, b.record_interval);
  EXPECT_EQ(a.snapshot_interval, b.snapshot_interval);
  EXPECT_EQ(a.restart_interval, b.restart_interval);
  EXPECT_EQ(a.core_diameter_fraction, b.core_diameter_fraction);
}

inline void expect_equal(BreakageLaw const& a, BreakageLaw const& b) {
  EXPECT_EQ(a.strength, b.strength);
  EXPECT_EQ(a.weibull_modulus, b.weibull_modulus);
  EXPECT_EQ(a.reference_diameter, b.reference_diameter);
  EXPECT_EQ(a.smallest_diameter, b.smallest_diameter);
}

inline void expect_equal(Case const& a, Case const& b) {
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.mode, b.mode);
  expect_equal(a.powder, b.powder);
  expect_equal(a.contacts.law, b.contacts.law);
  expect_equal(a.contacts.grain_grain, b.contacts.grain_grain);
  expect_equal(a.contacts.grain_wall, b.contacts.grain_wall);
  expect_equal(a.breakage, b.breakage);
  expect_equal(a.tooling, b.tooling);
  ASSERT_EQ(a.stages.size(), b.stages.size());
  for (std::size_t i = 0; i < a.stages.size(); ++i)
    expect_equal(a.stages[i], b.stages[i]);
  expect_equal(a.time_stepping, b.time_stepping);
  expect_equal(a.output, b.output);
  EXPECT_EQ(a.gravity, b.gravity);
}

} // namespace coupling
