#include "coupling/case_schema_parts.hpp"

namespace coupling::case_entries {

using enum EntryKind;
using enum Physical;

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
      {at + "Punch tilt", quantity, length, "0 mm", within(0.0, 0.01), "",
       "How much higher the upper punch's face stands at +x than at -x, across the bore; the "
       "middle "
       "stays where it was. Needs Mode = rigid."},
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

} // namespace coupling::case_entries
