#pragma once

#include "coupling/case_schema.hpp"

/// The parts of the case's table of entries, a file for each thing that is described, and the
/// ranges that they share.
namespace coupling::case_entries {

inline constexpr Range any{};
inline constexpr Range positive{.low = 0.0, .is_low_allowed = false};
inline constexpr Range not_negative{.low = 0.0};
constexpr Range within(double low, double high) {
  return {.low = low, .high = high};
}
constexpr Range above_up_to(double low, double high) {
  return {.low = low, .high = high, .is_low_allowed = false};
}

// The limits of the ranges are there to catch a missing unit (a 22 m die, a modulus of 250 Pa), not
// to judge physics.
inline constexpr Range modulus_range = within(1e5, 2e12);
inline constexpr Range density_range = within(10.0, 3e4);
inline constexpr Range poisson_range{
    .low = -1.0, .high = 0.5, .is_low_allowed = false, .is_high_allowed = false};
inline constexpr Range tool_size = within(1e-5, 2.0);

// The grains: case_schema_powder.cpp, case_schema_contacts.cpp.
std::vector<Entry> powder_entries();
std::vector<Entry> component_entries(int number);
std::vector<Entry> breakage_entries();
std::vector<Entry> contact_entries();
/// @param at        section, with its slash
/// @param cohesion  default of the cohesion energy density
std::vector<Entry> interaction_entries(std::string const& at, std::string const& cohesion);

// The tools: case_schema_tools.cpp.
std::vector<Entry> tooling_entries();
std::vector<Entry> elastic_entries();
std::vector<Entry> tool_shape_entries();

// The machine and what it is told: case_schema_press.cpp.
std::vector<Entry> frame_entries();
std::vector<Entry> load_cell_entries();
std::vector<Entry> stage_entries(int number);

} // namespace coupling::case_entries
