#include "coupling/case_schema_parts.hpp"

#include <fmt/format.h>

namespace coupling::case_entries {

using enum EntryKind;
using enum Physical;

std::vector<Entry> powder_entries() {
  return {
      {"Powder/Total mass", quantity, mass, "9.13 g", within(1e-12, 1e3), "",
       "Mass of all grains."},
      {"Powder/Fill method", choice, ratio, "random", any, "random | file | state",
       "How the die is filled: seeded random positions, a packing file, or the grains of an "
       "earlier run."},
      {"Powder/Fill file", file, ratio, "", any, "",
       "Packing (CSV) for Fill method = file; restart file or run folder for state."},
      {"Powder/Fill height", quantity, length, "20 mm", tool_size, "",
       "Height of the virtual cylinder that is filled; the upper punch starts there."},
      {"Powder/Packing seed", count, ratio, "1", within(0, 9e15), "",
       "Seed of the random positions."},
      {"Powder/Settle time", quantity, time, "0 s", within(0.0, 1e3), "",
       "Time that the grains fall under gravity before the first stage."},
      {"Powder/Fill state", quantity, ratio, "0", within(0.0, 1.0), "",
       "Share of static friction that grains lack while they settle, as if the die were tapped: a "
       "denser start. Needs Settle time."},
      {"Powder/Added fines/Share", quantity, ratio, "0 %", within(0.0, 0.5), "",
       "Share of every component's mass that is taken from its size classes and given to finer "
       "grains; the mass stays."},
      {"Powder/Added fines/Diameter", quantity, length, "0 mm", within(0.0, 0.1), "",
       "Diameter of those grains, below that of every size class."},
  };
}

std::vector<Entry> breakage_entries() {
  std::string const at = "Breakage/";
  return {
      {at + "Strength", quantity, modulus, "0 Pa", within(0.0, 1e13), "",
       "Largest contact force over diameter squared that 37 % of grains of the reference diameter "
       "survive; 0: grains do not break."},
      {at + "Weibull modulus", quantity, ratio, "5", within(0.5, 100.0), "",
       "Scatter of strength, and its fall with size: (d/d_0)^(-3/m)."},
      {at + "Reference diameter", quantity, length, "1 mm", above_up_to(0.0, 0.1), "",
       "d_0 of that."},
      {at + "Smallest diameter", quantity, length, "0.5 mm", above_up_to(0.0, 0.1), "",
       "Grains of up to this size do not break; it bounds the time step."},
  };
}

/// The seed's two components; the others are absent until they have a name.
std::vector<Entry> component_entries(int number) {
  bool const is_first = number == 1, is_second = number == 2;
  std::string const at = fmt::format("Powder/Component {}/", number);
  std::string const sizes = "0.5 mm: 70 %, 1 mm: 10 %, 2 mm: 15 %, 3 mm: 5 %";
  return {
      {at + "Name", text, ratio,
       is_first    ? "MgO"
       : is_second ? "Al2O3"
                   : "",
       any, "", "Name of the component; empty where there is none."},
      {at + "Mass fraction", quantity, ratio,
       is_first    ? "80 %"
       : is_second ? "20 %"
                   : "0 %",
       within(0.0, 1.0), "", "Share of the total mass; all components together make 100 %."},
      {at + "Density", quantity, density, is_first ? "3500 kg/m^3" : "3000 kg/m^3", density_range,
       "", "Density of the grains."},
      {at + "Young's modulus", quantity, modulus, "250 MPa", modulus_range, "",
       "Young's modulus of the grains."},
      {at + "Poisson's ratio", quantity, ratio, "0.25", poisson_range, "",
       "Poisson's ratio of the grains."},
      {at + "Size classes", size_classes, length, is_first ? sizes : "0.5 mm: 100 %",
       above_up_to(0.0, 0.1), "",
       "Diameters, each with its share of the component's mass: 0.5 mm: 35 %, 1 mm: 65 %."},
  };
}

} // namespace coupling::case_entries
