#include "coupling/case_schema_parts.hpp"

#include <iterator>

namespace coupling {

using namespace case_entries;

namespace {

using enum EntryKind;
using enum Physical;

std::vector<Entry> general_entries() {
  return {
      {"Title", text, ratio, "Seed press cycle", any, "", "One line that heads the report."},
      {"Mode", choice, ratio, "rigid", any,
       "rigid | one_way | two_way_explicit | two_way_secant | two_way_implicit",
       "Whether the tools deform, and how grains and tools are coupled."},
  };
}

std::vector<Entry> running_entries() {
  return {
      {"Time stepping/Rayleigh fraction", quantity, ratio, "0.1", above_up_to(0.0, 0.5), "",
       "Time step as a fraction of the smallest Rayleigh time of the grains."},
      {"Time stepping/Adaptive", truth, ratio, "false", any, "",
       "Follow the stiffness of the present contacts."},
      {"Time stepping/Safety", quantity, ratio, "0.8", above_up_to(0.0, 1.0), "",
       "Adaptive step as a fraction of the stable one."},
      {"Time stepping/Largest relative overlap", quantity, ratio, "1.8", above_up_to(0.0, 2.0), "",
       "Guard: largest overlap over the smaller radius. At 2 the smaller grain is inside; the "
       "seed's softest setup comes to 1.4."},
      {"Time stepping/Largest energy error", quantity, ratio, "0.1", above_up_to(0.0, 10.0), "",
       "Guard: energy that is not accounted for, over the work done so far."},
      {"Output/Record interval", quantity, time, "0.25 ms", above_up_to(0.0, 1e6), "",
       "Time between rows of curves.csv."},
      {"Output/Snapshot interval", quantity, time, "5 ms", within(0.0, 1e6), "",
       "Time between pictures for ParaView; 0: none."},
      {"Output/Restart interval", quantity, time, "10 min", above_up_to(0.0, 1e6), "",
       "Wall-clock time between restart files."},
      {"Output/Core diameter fraction", quantity, ratio, "0.7", above_up_to(0.0, 1.0), "",
       "Diameter of the core in which porosity_core is measured, over the bore diameter."},
      {"Gravity/x", quantity, acceleration, "0 m/s^2", within(-1e4, 1e4), "",
       "Gravity across the press axis."},
      {"Gravity/y", quantity, acceleration, "0 m/s^2", within(-1e4, 1e4), "",
       "Gravity across the press axis."},
      {"Gravity/z", quantity, acceleration, "-9.81 m/s^2", within(-1e4, 1e4), "",
       "Gravity along the press axis."},
  };
}

std::vector<Entry> all_entries() {
  std::vector<Entry> entries;
  auto const append = [&](std::vector<Entry> part) {
    entries.insert(entries.end(), std::make_move_iterator(part.begin()),
                   std::make_move_iterator(part.end()));
  };
  append(general_entries());
  append(powder_entries());
  for (int number = 1; number <= max_components; ++number)
    append(component_entries(number));
  append(contact_entries());
  append(interaction_entries("Contact/Particle-particle/", "5e6 J/m^3"));
  append(interaction_entries("Contact/Particle-wall/", "0 J/m^3"));
  append(breakage_entries());
  append(tooling_entries());
  append(elastic_entries());
  append(tool_shape_entries());
  append(frame_entries());
  append(load_cell_entries());
  for (int number = 1; number <= max_stages; ++number)
    append(stage_entries(number));
  append(running_entries());
  return entries;
}

} // namespace

std::span<Entry const> case_schema() {
  static std::vector<Entry> const entries = all_entries();
  return entries;
}

} // namespace coupling
