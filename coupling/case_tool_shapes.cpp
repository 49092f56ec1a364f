#include "coupling/case_build.hpp"
#include "coupling/case_checks.hpp"

#include <fmt/format.h>

#include <cmath>

// Shapes of deformable tools. Only what applies is read, so that what does not is refused.
namespace coupling {
namespace {

std::string const at = "Deformable tools/";

void read_mesh_files(CaseReader& read, ElasticToolShapes& shapes) {
  shapes.die_file = read.file(at + "Die mesh file");
  shapes.upper_punch_file = read.file(at + "Upper punch mesh file");
  shapes.lower_punch_file = read.file(at + "Lower punch mesh file");
  if (!shapes.die_file.empty() || !shapes.upper_punch_file.empty() ||
      !shapes.lower_punch_file.empty())
    shapes.mesh_scale = read.number(at + "Mesh scale");
  read.refuse_unread(at + "Mesh scale", "no mesh file is named");
}

/// The ring of a die that is made has a thickness; of one from a mesh file, a material; an STL has
/// no second region.
void read_ring(CaseReader& read, ElasticTools& tools, bool is_stl) {
  std::string const modulus = at + "Ring Young's modulus", ratio = at + "Ring Poisson's ratio";
  if (is_stl && tools.shapes.die_file.empty()) {
    read.refuse_unread(at + "Ring", "Tooling/Die file is an STL of one body");
    return;
  }
  bool const is_made = tools.shapes.die_file.empty();
  if (is_made)
    tools.shapes.ring_thickness = read.number(at + "Ring thickness");
  bool const has_ring =
      is_made ? tools.shapes.ring_thickness > 0.0 : read.is_given(modulus) || read.is_given(ratio);
  if (has_ring)
    tools.ring = continuum::ElasticMaterial{.young_modulus = read.number(modulus),
                                            .poisson_ratio = read.number(ratio)};
  read.refuse_unread(at + "Ring",
                     is_made ? "Ring thickness = 0" : "Die mesh file brings the die's shape");
}

void read_punch_face(CaseReader& read, ElasticToolShapes& shapes) {
  std::string const face = read.choice(at + "Punch face");
  if (face == "bevelled")
    shapes.punch_face = continuum::BevelledFace{.width = read.number(at + "Bevel width"),
                                                .depth = read.number(at + "Bevel depth")};
  else if (face == "concave")
    shapes.punch_face = continuum::ConcaveFace{.depth = read.number(at + "Cup depth"),
                                               .land = read.number(at + "Cup land")};
  for (char const* part : {"Bevel", "Cup"})
    read.refuse_unread(at + part, "Punch face = " + face);
}

double millimetres(double length) {
  return 1e3 * length;
}

/// What tool_shape.hpp allows, in the case's words.
void check_bevel(Case const& setup, CaseReader const& read, continuum::BevelledFace const& bevel) {
  double const radius = 0.5 * setup.tooling.bore_diameter, length = setup.tooling.punch_length;
  if (!(bevel.width > 0.0 && bevel.width < radius))
    read.refuse(at + "Bevel width",
                fmt::format("is not between 0 and the punch's radius of {:.4g} mm (a flat land "
                            "stays in the middle). Choose a width?",
                            millimetres(radius)));
  if (bevel.depth == 0.0 || std::abs(bevel.depth) >= length)
    read.refuse(at + "Bevel depth",
                fmt::format("has no magnitude between 0 and the punch's length of {:.4g} mm (a "
                            "bevel without depth is a flat face). Choose a depth?",
                            millimetres(length)));
  if (bevel.depth < 0.0 && setup.powder.fill_method == FillMethod::random)
    read.refuse(at + "Bevel depth", "reaches into the powder (random filling knows the flat part "
                                    "of a face only). Take Fill method = file or state?");
}

void check_cup(Case const& setup, CaseReader const& read, continuum::ConcaveFace const& cup) {
  double const radius = 0.5 * setup.tooling.bore_diameter;
  if (!(cup.land >= 0.0 && cup.land < radius))
    read.refuse(at + "Cup land", fmt::format("is not between 0 and the punch's radius of {:.4g} mm "
                                             "(a cup stays inside). Choose a width?",
                                             millimetres(radius)));
  double const deepest = std::min(radius - cup.land, setup.tooling.punch_length);
  if (!(cup.depth > 0.0 && cup.depth < deepest))
    read.refuse(at + "Cup depth", fmt::format("is not between 0 and {:.4g} mm (the opening's "
                                              "radius, or the punch's length). Choose a depth?",
                                              millimetres(deepest)));
}

void refuse_shapes_of_analytic_walls(ElasticToolShapes const& shapes, CaseReader const& read) {
  std::string const reason = "is not used (Tooling/Walls = analytic has a plain cylinder and "
                             "planes). Set Walls = surface?";
  for (auto const& [entry, file] : {std::pair{"Die mesh file", &shapes.die_file},
                                    {"Upper punch mesh file", &shapes.upper_punch_file},
                                    {"Lower punch mesh file", &shapes.lower_punch_file}})
    if (!file->empty())
      read.refuse(at + entry, reason);
  if (!std::holds_alternative<continuum::FlatFace>(shapes.punch_face))
    read.refuse(at + "Punch face", reason);
}

} // namespace

void read_tool_shapes(CaseReader& read, ElasticTools& tools, Tooling const& tooling) {
  read_mesh_files(read, tools.shapes);
  read_ring(read, tools, !tooling.die_file.empty());
  read_punch_face(read, tools.shapes);
  tools.shapes.largest_gap = read.number(at + "Largest gap");
  tools.stress_interval = read.number(at + "Stress interval");
}

void check_tool_shapes(Case const& setup, CaseReader const& read) {
  ElasticToolShapes const& shapes = setup.elastic.shapes;
  Tooling const& tooling = setup.tooling;
  bool const has_die = !shapes.die_file.empty() || !tooling.die_file.empty();
  bool const has_upper = !shapes.upper_punch_file.empty() || !tooling.upper_punch_file.empty();
  bool const has_lower = !shapes.lower_punch_file.empty() || !tooling.lower_punch_file.empty();
  bool const is_rigid = setup.elastic.coupling.mode == CouplingMode::rigid;
  if (tooling.walls == WallKind::analytic)
    refuse_shapes_of_analytic_walls(shapes, read);
  if (!is_rigid && has_die && setup.elastic.die_support == ToolSupport::rollers)
    read.refuse(at + "Die support", "leaves a die from a file free to turn about z (a "
                                    "mechanism; such a mesh has no pins). Set it to clamped?");
  if (!is_rigid && (has_upper || has_lower) && setup.elastic.punch_support == ToolSupport::rollers)
    read.refuse(at + "Punch support", "leaves a punch from a file free to turn about z (a "
                                      "mechanism; such a mesh has no pins). Set it to clamped?");
  if (has_upper && has_lower && !std::holds_alternative<continuum::FlatFace>(shapes.punch_face))
    read.refuse(at + "Punch face", "is not used (both punches come from files). Remove it?");
  if (auto const* bevel = std::get_if<continuum::BevelledFace>(&shapes.punch_face))
    check_bevel(setup, read, *bevel);
  if (auto const* cup = std::get_if<continuum::ConcaveFace>(&shapes.punch_face))
    check_cup(setup, read, *cup);
}

} // namespace coupling
