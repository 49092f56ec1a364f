#include "coupling/case_schema.hpp"

#include "coupling/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace coupling {

namespace {

using enum EntryKind;
using enum Physical;

constexpr Range any{};
constexpr Range positive{.low = 0.0, .is_low_allowed = false};
constexpr Range not_negative{.low = 0.0};
constexpr Range within(double low, double high) {
  return {.low = low, .high = high};
}
constexpr Range above_up_to(double low, double high) {
  return {.low = low, .high = high, .is_low_allowed = false};
}

// The limits of the ranges are there to catch a missing unit (a 22 m die, a modulus of 250 Pa), not
// to judge physics.
constexpr Range modulus_range = within(1e5, 2e12);
constexpr Range density_range = within(10.0, 3e4);
constexpr Range poisson_range{
    .low = -1.0, .high = 0.5, .is_low_allowed = false, .is_high_allowed = false};
constexpr Range tool_size = within(1e-5, 2.0);

std::vector<Entry> general_entries() {
  return {
      {"Title", text, ratio, "Seed press cycle", any, "", "One line that heads the report."},
      {"Mode", choice, ratio, "rigid", any,
       "rigid | one_way | two_way_explicit | two_way_secant | two_way_implicit",
       "Whether the tools deform, and how grains and tools are coupled."},
  };
}

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

std::vector<Entry> contact_entries() {
  std::string const at = "Contact/";
  return {
      {at + "Preset", choice, ratio, "liggghts", any, "liggghts | edem | custom",
       "Laws that go together. liggghts: hertz, sjkr2, mindlin. edem: hertz, linear_reduced, "
       "mindlin."},
      {at + "Normal law", choice, ratio, "preset", any,
       "preset | hertz | hooke | jkr | thornton_ning | edinburgh",
       "Normal force; thornton_ning and edinburgh are elasto-plastic."},
      {at + "Cohesion law", choice, ratio, "preset", any,
       "preset | none | sjkr | sjkr2 | linear_reduced | linear_hertz_circle",
       "Cohesive force k A: the name says which area A."},
      {at + "Tangential law", choice, ratio, "preset", any,
       "preset | frictionless | mindlin | hooke_spring", "Tangential force."},
      {at + "Rolling law", choice, ratio, "none", any, "none | constant_torque",
       "Resistance to rolling."},
      {at + "Friction limit", choice, ratio, "net", any, "net | elastic",
       "Normal force that limits friction: net counts cohesion (LIGGGHTS 3.3.1), elastic does not "
       "(3.8 default)."},
      {at + "Tangential damping", truth, ratio, "true", any, "",
       "Dashpot beside the tangential spring."},
      {at + "Limit force", truth, ratio, "false", any, "",
       "Clip the attraction of the normal dashpot at the end of a rebound."},
      {at + "Characteristic velocity", quantity, speed, "0.2 m/s", positive, "",
       "Impact speed at which hooke matches hertz; used by hooke only."},
      {at + "Yield pressure", quantity, modulus, "0 Pa", within(0.0, 1e13), "",
       "Pressure at which a contact yields, about 2.8 times the yield stress; used by Normal law = "
       "thornton_ning."},
      {at + "Plasticity ratio", quantity, ratio, "0", within(0.0, 0.999), "",
       "1 - k1/k2 of loading and unloading; used by Normal law = edinburgh."},
      {at + "Adhesion exponent", quantity, ratio, "1.5", within(1.0, 10.0), "",
       "Exponent chi of the adhesive branch; used by Normal law = edinburgh."},
      {at + "Viscous time", quantity, time, "0 s", within(0.0, 1e3), "",
       "A of a dashpot A dF/dd at every contact: the powder's own rate dependence."},
      {at + "Precision", choice, ratio, "mixed", any, "mixed | double",
       "mixed: overlaps in double, forces in single precision."},
  };
}

std::vector<Entry> interaction_entries(std::string const& at, std::string const& cohesion) {
  return {
      {at + "Coefficient of restitution", quantity, ratio, "0.5", above_up_to(0.0, 1.0), "",
       "Rebound speed over impact speed."},
      {at + "Coefficient of static friction", quantity, ratio, "0.2", within(0.0, 10.0), "",
       "Coulomb friction."},
      {at + "Coefficient of rolling friction", quantity, ratio, "0", within(0.0, 10.0), "",
       "Used by Rolling law = constant_torque."},
      {at + "Cohesion energy density", quantity, energy_density, cohesion, within(0.0, 1e12), "",
       "k of the cohesive force k A."},
      {at + "Surface energy", quantity, surface_energy, "0 J/m^2", within(0.0, 1e4), "",
       "Work of adhesion of the pair; used by Normal law = jkr and edinburgh."},
  };
}

std::vector<Entry> tooling_entries() {
  std::string const at = "Tooling/";
  return {
      {at + "Walls", choice, ratio, "surface", any, "surface | analytic",
       "surface: STL triangles; analytic: exact cylinder and planes."},
      {at + "Bore diameter", quantity, length, "22.05 mm", within(1e-4, 0.5), "",
       "Inner diameter of the die."},
      {at + "Die height", quantity, length, "20 mm", tool_size, "",
       "Height of the bore above the lower punch."},
      {at + "Wall thickness", quantity, length, "10 mm", tool_size, "",
       "Thickness of the die wall."},
      {at + "Punch length", quantity, length, "10 mm", tool_size, "", "Length of both punches."},
      {at + "Chordal tolerance", quantity, length, "0.01 mm", above_up_to(0.0, 1e-2), "",
       "Largest distance between a generated tool surface and the smooth one."},
      {at + "Die file", file, ratio, "", any, "",
       "STL of the die; empty: generated from the dimensions."},
      {at + "Upper punch file", file, ratio, "", any, "",
       "STL of the upper punch; empty: generated."},
      {at + "Lower punch file", file, ratio, "", any, "",
       "STL of the lower punch; empty: generated."},
      {at + "STL scale", quantity, length, "1 m", above_up_to(0.0, 1.0), "",
       "Length of one unit of the STL files: 1 mm for a drawing in millimetres."},
      {at + "Density", quantity, density, "8000 kg/m^3", density_range, "",
       "Density of the tools."},
      {at + "Young's modulus", quantity, modulus, "200 MPa", modulus_range, "",
       "Young's modulus of the tools at a contact."},
      {at + "Poisson's ratio", quantity, ratio, "0.29", poisson_range, "",
       "Poisson's ratio of the tools."},
  };
}

std::vector<Entry> elastic_entries() {
  std::string const at = "Deformable tools/";
  return {
      {at + "Young's modulus", quantity, modulus, "210 GPa", within(1e5, 1e18), "",
       "Young's modulus of the tools as bodies; at a contact Tooling's counts. Mode = rigid takes "
       "the "
       "shapes of this section and nothing else."},
      {at + "Poisson's ratio", quantity, ratio, "0.3", poisson_range, "",
       "Poisson's ratio of the tools as bodies."},
      {at + "Yield strength", quantity, modulus, "0 MPa", within(0.0, 1e12), "",
       "Compared with the largest von Mises stress; 0: unknown."},
      {at + "Fatigue strength", quantity, modulus, "0 MPa", within(0.0, 1e12), "",
       "Compared with the largest von Mises stress; 0: unknown."},
      {at + "Cell size", quantity, length, "3.5 mm", tool_size, "",
       "Width of the finite elements where grains press."},
      {at + "Die support", choice, ratio, "clamped", any, "rollers | clamped",
       "How the die stands on its bottom: held, or free to breathe on three pins, which give way "
       "to loads that do not balance."},
      {at + "Punch support", choice, ratio, "clamped", any, "rollers | clamped | guided",
       "How a punch is held at its back; guided: and on its side, against going aside."},
      {at + "Window", count, ratio, "100", within(1, 1e6), "",
       "Steps of the grains between two exchanges of loads and deformation."},
      {at + "Accelerator", choice, ratio, "iqn_ils", any, "aitken | iqn_ils",
       "How two_way_implicit finds the deformation that its own loads hold."},
      {at + "Tolerance", quantity, ratio, "1e-4", above_up_to(0.0, 0.1), "",
       "Change of the loads in an iteration of two_way_implicit that ends it."},
      {at + "Largest iterations", count, ratio, "20", within(1, 1000), "",
       "Iterations of a window after which two_way_implicit gives up."},
  };
}

std::vector<Entry> tool_shape_entries() {
  std::string const at = "Deformable tools/";
  return {
      {at + "Ring thickness", quantity, length, "0 mm", within(0.0, 2.0), "",
       "Thickness of a ring bonded round the die, outside Wall thickness; 0: none."},
      {at + "Ring Young's modulus", quantity, modulus, "210 GPa", within(1e5, 1e18), "",
       "Young's modulus of the ring, or of the second region of Die mesh file."},
      {at + "Ring Poisson's ratio", quantity, ratio, "0.3", poisson_range, "",
       "Poisson's ratio of the ring."},
      {at + "Punch face", choice, ratio, "flat", any, "flat | bevelled | concave",
       "Faces of both punches; the flat part of a face stands where a flat face would."},
      {at + "Bevel width", quantity, length, "0 mm", within(0.0, 2.0), "",
       "Width of a bevelled face's cone along the radius, from the rim inwards."},
      {at + "Bevel depth", quantity, length, "0 mm", within(-2.0, 2.0), "",
       "How far the rim of a bevelled face stands back from the powder; negative: into it."},
      {at + "Cup depth", quantity, length, "0 mm", within(0.0, 2.0), "",
       "Depth of a concave face's spherical cup under its land."},
      {at + "Cup land", quantity, length, "0 mm", within(0.0, 2.0), "",
       "Width of the flat land round the cup of a concave face."},
      {at + "Die mesh file", file, ratio, "", any, "",
       "gmsh file (.msh) of the die with surfaces bore and bottom; empty: made from the "
       "dimensions."},
      {at + "Upper punch mesh file", file, ratio, "", any, "",
       "gmsh file of the upper punch with surfaces face, at z = 0, and back; empty: made."},
      {at + "Lower punch mesh file", file, ratio, "", any, "",
       "gmsh file of the lower punch with surfaces face, at z = 0, and back; empty: made."},
      {at + "Mesh scale", quantity, length, "1 m", above_up_to(0.0, 1.0), "",
       "Length of one unit of the mesh files: 1 mm for a drawing in millimetres."},
      {at + "Largest gap", quantity, length, "0.05 mm", above_up_to(0.0, 1e-2), "",
       "Largest distance between Tooling's STL of a tool, which grains touch, and the mesh "
       "behind."},
      {at + "Stress interval", quantity, time, "0 s", within(0.0, 1e6), "",
       "Between files of the tools' stress (TOOL_stress.pvd), at the ends of windows; shorter than "
       "a window: each of them; 0: at the largest force only."},
  };
}

std::vector<Entry> frame_entries() {
  std::string const at = "Press frame/";
  return {
      {at + "Stiffness", quantity, stiffness, "0 N/m", within(0.0, 1e13), "",
       "Stiffness of the machine between command and upper punch; 0: rigid."},
      {at + "Seating", quantity, length, "0 mm", within(0.0, 0.01), "",
       "What the machine's joints give in all, on top of its stiffness, until they are seated."},
      {at + "Seating force", quantity, force, "0 N", within(0.0, 1e7), "",
       "Force scale F_s of that: seating (1 - exp(-F / F_s))."},
  };
}

/// Defaults of the seed's press cycle: down to 8 mm in 0.06 s, up for 0.04 s, die and punch
/// removed, 0.05 s free.
struct StageDefaults {
  char const *kind, *name, *tools, *speed, *until, *duration, *gap;
};

StageDefaults stage_defaults(int number) {
  switch (number) {
  case 1:
    return {"move", "loading", "upper_punch", "-0.2 m/s", "gap", "0 s", "8 mm"};
  case 2:
    return {"move", "unloading", "upper_punch", "0.2 m/s", "gap", "0 s", "16 mm"};
  case 3:
    return {"release", "release", "die, upper_punch", "0 m/s", "time", "0 s", "0 mm"};
  case 4:
    return {"free", "relaxation", "", "0 m/s", "time", "0.05 s", "0 mm"};
  default:
    return {"none", "", "", "0 m/s", "time", "0 s", "0 mm"};
  }
}

std::vector<Entry> stage_entries(int number) {
  StageDefaults const stage = stage_defaults(number);
  std::string const at = fmt::format("Press programme/Stage {}/", number);
  return {
      {at + "Kind", choice, ratio, stage.kind, any, "none | move | hold | release | free | follow",
       "move the tools, hold them, release (remove) them, drive nothing, or follow a measured gap; "
       "none: no such stage."},
      {at + "Name", text, ratio, stage.name, any, "",
       "Name of the stage; empty: stage and its number."},
      {at + "Tools", tools, ratio, stage.tools, any, "",
       "Tools that move, are held at a force, or are released."},
      {at + "Speed", quantity, speed, stage.speed, within(-1e3, 1e3), "",
       "Speed of a move, positive up."},
      {at + "Until", choice, ratio, stage.until, any, "time | gap | force | flush",
       "What ends a move; flush: the face of the lower punch is level with the die's rim."},
      {at + "Duration", quantity, time, stage.duration, within(0.0, 1e6), "",
       "Length of the stage; for another limit the longest it may take (0: no bound)."},
      {at + "Gap", quantity, length, stage.gap, within(0.0, 2.0), "",
       "Gap between the punch faces that ends a move."},
      {at + "Force", quantity, force, "0 N", within(0.0, 1e9), "",
       "Force on the tool that ends a move or is held."},
      {at + "Servo", truth, ratio, "false", any, "", "Hold: keep Force instead of the position."},
      {at + "Follow file", file, ratio, "", any, "",
       "Follow: CSV with the columns time and punch_gap, the punch faces' distance as measured."},
      {at + "Time scale", quantity, ratio, "1", above_up_to(0.0, 1e6), "",
       "Follow: simulated time over measured time; below 1 the press runs faster than measured."},
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
  append(tooling_entries());
  append(elastic_entries());
  append(tool_shape_entries());
  append(frame_entries());
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
