#include "coupling/case_build.hpp"

#include "coupling/case_checks.hpp"
#include "coupling/case_print.hpp"
#include "coupling/case_schema.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>

namespace coupling {

namespace {

/// A name goes into tables and file names.
std::string read_name(CaseReader& read, std::string const& path) {
  std::string const name = read.words(path);
  if (name.size() > 40 || name.find_first_of(",;\"'/\\<>") != std::string::npos)
    read.refuse(path,
                "is no name (at most 40 bytes, without , ; \" ' / \\ < >). Choose a plainer one?");
  return name;
}

dem::Material read_material(CaseReader& read, std::string const& section, std::string name) {
  return {.name = std::move(name),
          .density = read.number(section + "Density"),
          .young_modulus = read.number(section + "Young's modulus"),
          .poisson_ratio = read.number(section + "Poisson's ratio")};
}

FillMethod fill_method(std::string const& name) {
  if (name == "file")
    return FillMethod::file;
  return name == "state" ? FillMethod::state : FillMethod::random;
}

TimeStepping read_time_stepping(CaseReader& read) {
  std::string const at = "Time stepping/";
  return {.rayleigh_fraction = read.number(at + "Rayleigh fraction"),
          .adaptive = read.truth(at + "Adaptive"),
          .safety = read.number(at + "Safety"),
          .max_relative_overlap = read.number(at + "Largest relative overlap"),
          .max_energy_error = read.number(at + "Largest energy error")};
}

Output read_output(CaseReader& read) {
  std::string const at = "Output/";
  return {.record_interval = read.number(at + "Record interval"),
          .snapshot_interval = read.number(at + "Snapshot interval"),
          .restart_interval = read.number(at + "Restart interval"),
          .core_diameter_fraction = read.number(at + "Core diameter fraction")};
}

} // namespace

std::string read_mode(CaseReader& read) {
  return read.choice("Mode");
}

ElasticTools read_elastic_tools(CaseReader& read, std::string const& mode, Tooling const& tooling) {
  static std::map<std::string, CouplingMode> const modes{
      {"rigid", CouplingMode::rigid},
      {"one_way", CouplingMode::one_way},
      {"two_way_explicit", CouplingMode::two_way_explicit},
      {"two_way_secant", CouplingMode::two_way_secant},
      {"two_way_implicit", CouplingMode::two_way_implicit}};
  std::string const at = "Deformable tools/";
  auto const strength = [&](std::string const& name) -> std::optional<double> {
    double const value = read.number(at + name);
    return value > 0.0 ? std::optional(value) : std::nullopt;
  };
  auto const support = [&](std::string const& name) {
    std::string const chosen = read.choice(at + name);
    if (chosen == "guided")
      return ToolSupport::guided;
    return chosen == "clamped" ? ToolSupport::clamped : ToolSupport::rollers;
  };
  ElasticTools tools{.material = {.young_modulus = read.number(at + "Young's modulus"),
                                  .poisson_ratio = read.number(at + "Poisson's ratio"),
                                  .yield_strength = strength("Yield strength"),
                                  .fatigue_strength = strength("Fatigue strength")},
                     .cell_size = read.number(at + "Cell size"),
                     .die_support = support("Die support"),
                     .punch_support = support("Punch support"),
                     .coupling = {.mode = modes.at(mode),
                                  .window = read.count(at + "Window"),
                                  .accelerator = read.choice(at + "Accelerator") == "aitken"
                                                     ? Accelerator::aitken
                                                     : Accelerator::iqn_ils,
                                  .tolerance = read.number(at + "Tolerance"),
                                  .most_iterations = read.count(at + "Largest iterations")}};
  read_tool_shapes(read, tools, tooling);
  return tools;
}

Powder read_powder(CaseReader& read) {
  Powder powder;
  for (int number = 1; number <= max_components; ++number) {
    std::string const at = fmt::format("Powder/Component {}/", number);
    std::string const name = read_name(read, at + "Name");
    if (name.empty()) {
      read.refuse_unread(at, fmt::format("component {} is absent while its Name is empty", number));
      continue;
    }
    powder.components.push_back({.material = read_material(read, at, name),
                                 .mass_fraction = read.number(at + "Mass fraction"),
                                 .sizes = read.size_classes(at + "Size classes")});
  }
  powder.total_mass = read.number("Powder/Total mass");
  powder.fill_method = fill_method(read.choice("Powder/Fill method"));
  if (powder.fill_method != FillMethod::random) {
    powder.fill_file = read.file("Powder/Fill file");
    if (powder.fill_file.empty())
      read.refuse("Powder/Fill file",
                  fmt::format("names no file (Fill method = {} reads one). Name it?",
                              read.resolved().at("Powder/Fill method")));
  } else
    read.refuse_unread("Powder/Fill file", "Fill method = random makes its own packing");
  powder.fill_height = read.number("Powder/Fill height");
  powder.seed = read.count("Powder/Packing seed");
  powder.settle_time = read.number("Powder/Settle time");
  read_fill(read, powder);
  return powder;
}

Tooling read_tooling(CaseReader& read) {
  std::string const at = "Tooling/";
  return {.walls = read.choice(at + "Walls") == "analytic" ? WallKind::analytic : WallKind::surface,
          .bore_diameter = read.number(at + "Bore diameter"),
          .die_height = read.number(at + "Die height"),
          .wall_thickness = read.number(at + "Wall thickness"),
          .punch_length = read.number(at + "Punch length"),
          .punch_tilt = read.number(at + "Punch tilt"),
          .chordal_tolerance = read.number(at + "Chordal tolerance"),
          .die_file = read.file(at + "Die file"),
          .upper_punch_file = read.file(at + "Upper punch file"),
          .lower_punch_file = read.file(at + "Lower punch file"),
          .stl_scale = read.number(at + "STL scale"),
          .material = read_material(read, at, "wall")};
}

FrameLaw read_frame(CaseReader& read) {
  std::string const at = "Press frame/";
  return {.stiffness = read.number(at + "Stiffness"),
          .seating = read.number(at + "Seating"),
          .seating_force = read.number(at + "Seating force"),
          .gap_offset = read.number(at + "Gap offset"),
          .thermal_drift = read.number(at + "Thermal drift")};
}

LoadCellErrors read_load_cell(CaseReader& read) {
  std::string const at = "Load cell/";
  return {.gain = read.number(at + "Gain"),
          .offset = read.number(at + "Offset"),
          .drift = read.number(at + "Drift"),
          .lag = read.number(at + "Time constant")};
}

Case build_case(CaseText const& text, std::filesystem::path const& file) {
  CaseReader read(text, file.parent_path());
  Case result;
  result.file = file;
  result.title = read.words("Title");
  result.mode = read_mode(read);
  result.powder = read_powder(read);
  result.contacts = read_contacts(read);
  result.breakage = read_breakage(read);
  result.tooling = read_tooling(read);
  result.elastic = read_elastic_tools(read, result.mode, result.tooling);
  result.frame = read_frame(read);
  result.load_cell = read_load_cell(read);
  result.stages = read_stages(read);
  result.time_stepping = read_time_stepping(read);
  result.output = read_output(read);
  result.gravity = {read.number("Gravity/x"), read.number("Gravity/y"), read.number("Gravity/z")};
  check_case(result, read);
  result.resolved_text = print_prm(read.resolved());
  return result;
}

} // namespace coupling
