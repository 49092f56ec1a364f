// What a case says of deformable tools may not apply, not fit, or be no tool: each refusal by its
// message.
#include "coupling/elastic/yielding_tool.hpp"
#include "dem/expect.hpp"
#include "tests/unit/coupling/elastic_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace coupling {
namespace {

using namespace elastic_case;
using continuum::PunchPlace;

std::string const at = "Deformable tools/";

/// How the tools of this case are refused, without the place `--set: `, and with FILE for the file.
std::string refusal(Overrides const& overrides, std::filesystem::path const& file = "") {
  support::ScratchFolder const cache; // of what is condensed before the refusal
  setenv("PRESSCHECK_CACHE", cache.path().c_str(), 1);
  try {
    make_yielding_tools(read(overrides));
    return "accepted";
  } catch (dem::InvalidInput const& problem) {
    std::string message = problem.what();
    if (message.starts_with("--set: "))
      message = message.substr(7);
    auto const found = file.empty() ? std::string::npos : message.find(file.string());
    return found == std::string::npos ? message
                                      : message.replace(found, file.string().size(), "FILE");
  }
}
std::string refusal(FileCase const& file, Overrides const& more = {}) {
  return refusal(file.with(more), file.path());
}

/// Refusals of a die from an STL.
struct StlCase {
  support::ScratchFolder folder;

  std::string refused_die(dem::TriangleSurface const& surface, Overrides overrides = {}) const {
    auto const file = folder.path() / "die.stl";
    dem::write_stl(file, surface, dem::StlFormat::ascii, 1e-3);
    overrides.push_back("Tooling/Die file=" + file.string());
    overrides.push_back("Tooling/STL scale=1 mm");
    return refusal(overrides, file);
  }
};

TEST(ElasticShapes, ThatDoNotApplyAreRefused) {
  EXPECT_EQ(refusal({at + "Cup depth=1 mm"}), "Deformable tools/Cup depth = 1 mm: is not used "
                                              "(Punch face = flat). Remove it?");
  EXPECT_EQ(refusal({at + "Punch face=concave", at + "Cup depth=1 mm", at + "Bevel width=1 mm"}),
            "Deformable tools/Bevel width = 1 mm: is not used (Punch face = concave). Remove it?");
  EXPECT_EQ(refusal({at + "Punch face=bevelled", at + "Cup land=1 mm"}),
            "Deformable tools/Cup land = 1 mm: is not used (Punch face = bevelled). Remove it?");
  EXPECT_EQ(refusal({at + "Ring Young's modulus=70 GPa"}),
            "Deformable tools/Ring Young's modulus = 70 GPa: is not used (Ring thickness = 0). "
            "Remove it?");
  EXPECT_EQ(refusal({at + "Mesh scale=1 mm"}),
            "Deformable tools/Mesh scale = 1 mm: is not used (no mesh file is named). Remove it?");
  FileCase const file("Die mesh file", die());
  EXPECT_EQ(refusal(file, {at + "Ring thickness=5 mm"}),
            "Deformable tools/Ring thickness = 5 mm: is not used (Die mesh file brings the die's "
            "shape). Remove it?");
  EXPECT_EQ(refusal(file, {at + "Ring Young's modulus=70 GPa"}),
            "FILE: it has 1 regions (a ring's material is for the second of two physical volumes). "
            "Leave out 'Ring Young's modulus' and 'Ring Poisson's ratio'?");
  std::string const same = file.path().string();
  EXPECT_EQ(refusal({at + "Upper punch mesh file=" + same, at + "Lower punch mesh file=" + same,
                     at + "Punch face=concave", at + "Cup depth=1 mm"}),
            "Deformable tools/Punch face = concave: is not used (both punches come from "
            "files). Remove it?");
}

TEST(ElasticShapes, ThatDoNotFitThePunchAreRefused) {
  auto const bevel = [](std::string const& width, std::string const& depth) {
    return refusal(
        {at + "Punch face=bevelled", at + "Bevel width=" + width, at + "Bevel depth=" + depth});
  };
  EXPECT_EQ(refusal({at + "Punch face=bevelled"}),
            "case.prm: Deformable tools/Bevel width = 0 mm (default): is not between 0 and the "
            "punch's radius of 11.03 mm (a flat land stays in the middle). Choose a width?");
  EXPECT_EQ(bevel("12 mm", "1 mm").substr(0, 49),
            "Deformable tools/Bevel width = 12 mm: is not betw");
  std::string const no_depth = ": has no magnitude between 0 and the punch's length of 10 mm (a "
                               "bevel without depth is a flat face). Choose a depth?";
  EXPECT_EQ(bevel("1 mm", "0 mm"), "Deformable tools/Bevel depth = 0 mm" + no_depth);
  EXPECT_EQ(bevel("1 mm", "10 mm"), "Deformable tools/Bevel depth = 10 mm" + no_depth);
  EXPECT_EQ(bevel("1 mm", "-1 mm"),
            "Deformable tools/Bevel depth = -1 mm: reaches into the powder (random filling knows "
            "the flat part of a face only). Take Fill method = file or state?");
  auto const cup = [](std::string const& depth, std::string const& land) {
    return refusal({at + "Punch face=concave", at + "Cup depth=" + depth, at + "Cup land=" + land});
  };
  EXPECT_EQ(cup("1 mm", "12 mm"),
            "Deformable tools/Cup land = 12 mm: is not between 0 and the punch's radius of 11.03 "
            "mm (a cup stays inside). Choose a width?");
  EXPECT_EQ(cup("9.1 mm", "2 mm"),
            "Deformable tools/Cup depth = 9.1 mm: is not between 0 and 9.025 mm (the opening's "
            "radius, or the punch's length). Choose a depth?");
  // atan(0.3 / 3) = 5.71 degrees between cone and side
  EXPECT_EQ(bevel("0.3 mm", "3 mm"),
            "case.prm: deformable tools: upper_punch: the surfaces 'face' and 'side' meet at 5.71 "
            "degrees (below 20.1 grains feel one surface, and only 'face' yields). Make the edge "
            "sharper, or name both as 'face'?");
}

TEST(ElasticShapes, OfAnalyticWallsAreRefused) {
  auto const analytic = [](Overrides more) {
    more.push_back("Tooling/Walls=analytic");
    more.push_back("Mode=rigid");
    return refusal(more);
  };
  std::string const reason = ": is not used (Tooling/Walls = analytic has a plain cylinder and "
                             "planes). Set Walls = surface?";
  EXPECT_EQ(analytic({at + "Punch face=concave", at + "Cup depth=1 mm"}),
            "Deformable tools/Punch face = concave" + reason);
  FileCase const file("Die mesh file", die());
  EXPECT_EQ(refusal(file, {"Tooling/Walls=analytic", "Mode=rigid"}),
            "Deformable tools/Die mesh file = FILE" + reason);
}

TEST(ElasticStl, ThatIsNoBodyOrAnotherToolIsRefused) {
  StlCase const stl;
  EXPECT_EQ(stl.refused_die(die_surface(0.8 * bore)),
            "FILE: its bore of 0.01764 m diameter is not 'Tooling/Bore diameter' = 0.02205 m about "
            "the z axis. Is 'STL scale' = 0.001 m right?");
  auto open = die_surface(bore);
  open.triangles.pop_back();
  std::string const torn = stl.refused_die(open);
  EXPECT_TRUE(torn.starts_with("case.prm: Tooling/Die file: FILE: the edge at (")) << torn;
  EXPECT_NE(torn.find("Is there a hole, or a part twice?"), std::string::npos) << torn;
  // the STL's round bore in front of a mesh of 32 straight cells: 53 um at their middles
  FileCase const mesh("Die mesh file", die());
  std::string const apart =
      stl.refused_die(die_surface(bore), mesh.with({at + "Largest gap=0.04 mm"}));
  EXPECT_TRUE(apart.starts_with("case.prm: deformable tools: die: the mesh and Tooling's STL are "))
      << apart;
  EXPECT_NE(apart.find(" m apart on 'bore' (Largest gap = 4e-05 m; "), std::string::npos) << apart;
  EXPECT_EQ(
      stl.refused_die(die_surface(bore), {at + "Ring thickness=5 mm"}),
      "Deformable tools/Ring thickness = 5 mm: is not used (Tooling/Die file is an STL of one "
      "body). Remove it?");
}

TEST(ElasticTools, WithoutSupportAreRefused) {
  FileCase const file("Die mesh file", die());
  EXPECT_EQ(refusal(file, {at + "Die support=rollers"}),
            "Deformable tools/Die support = rollers: leaves a die from a file free to turn "
            "about z (a mechanism; such a mesh has no pins). Set it to clamped?");
  FileCase const upper("Upper punch mesh file", punch(PunchPlace::upper));
  EXPECT_EQ(refusal(upper, {at + "Punch support=rollers"}),
            "Deformable tools/Punch support = rollers: leaves a punch from a file free to "
            "turn about z (a mechanism; such a mesh has no pins). Set it to clamped?");
}

TEST(ElasticTools, OfNegativeModulusAreRefused) {
  EXPECT_EQ(refusal({at + "Young's modulus=-210 GPa"}),
            "Deformable tools/Young's modulus = -210 GPa: is outside the allowed range (>= 100000 "
            "Pa, <= 1e+18 Pa). Choose a value inside it?");
  EXPECT_EQ(
      refusal({at + "Ring thickness=5 mm", at + "Ring Young's modulus=-70 GPa"}).substr(0, 51),
      "Deformable tools/Ring Young's modulus = -70 GPa: is");
}

TEST(ElasticMeshes, ThatAreMissingOrNoneAreRefused) {
  std::string const message = refusal({at + "Die mesh file=no/such.msh"});
  EXPECT_TRUE(message.starts_with("Deformable tools/Die mesh file = no/such.msh: does not exist"))
      << message;
  FileCase const file("Die mesh file", die());
  support::put_bytes(file.path(), "solid die\n");
  EXPECT_EQ(refusal(file), "case.prm: Deformable tools/Die mesh file: FILE: is no gmsh mesh (its "
                           "first line is not $MeshFormat). Was it saved as .msh, version 2.2 or "
                           "4.1?");
}

TEST(ElasticMeshes, WithoutTheNamedSurfacesAreRefused) {
  auto mesh = die();
  *std::ranges::find(mesh.surfaces, "bore") = "bohrung";
  std::string const message = refusal(FileCase("Die mesh file", mesh));
  EXPECT_TRUE(message.starts_with("case.prm: Deformable tools/Die mesh file: FILE: no physical "
                                  "surface 'bore' (it has "))
      << message;
  mesh = punch(PunchPlace::lower);
  *std::ranges::find(mesh.surfaces, "back") = "foot";
  std::string const of_punch = refusal(FileCase("Lower punch mesh file", mesh));
  EXPECT_TRUE(of_punch.starts_with("case.prm: Deformable tools/Lower punch mesh file: FILE: no "
                                   "physical surface 'back' (it has "))
      << of_punch;
}

TEST(ElasticMeshes, ThatAreInvertedOrOpenAreRefused) {
  auto mesh = die();
  for (int const i : {0, 2, 4, 6})
    std::swap(mesh.cells[0][i], mesh.cells[0][i + 1]);
  std::string const inverted = refusal(FileCase("Die mesh file", mesh));
  EXPECT_NE(inverted.find("FILE: cell 0 at ("), std::string::npos) << inverted;
  EXPECT_NE(inverted.find("is inverted"), std::string::npos) << inverted;

  mesh = die(); // a cell with a vertex of its own stands apart from its neighbours
  mesh.vertices.push_back(mesh.vertices[mesh.cells[0][7]]);
  mesh.cells[0][7] = mesh.vertices.size() - 1;
  std::string const torn = refusal(FileCase("Die mesh file", mesh));
  EXPECT_NE(torn.find("the body is torn there, not watertight"), std::string::npos) << torn;

  mesh = die(); // without a cell there are faces without a name
  mesh.cells.pop_back();
  std::string const open = refusal(FileCase("Die mesh file", mesh));
  EXPECT_TRUE(open.starts_with("case.prm: Deformable tools/Die mesh file: FILE: ")) << open;
  EXPECT_NE(open.find("boundary"), std::string::npos) << open;
}

TEST(ElasticMeshes, OfAnotherDieAreRefused) {
  std::string const not_the_bore = " m from the z axis (Tooling/Bore diameter = 0.02205 m about "
                                   "that axis is what the punches and the powder fit). Is Mesh "
                                   "scale = ";
  EXPECT_EQ(refusal(FileCase("Die mesh file", die()), {at + "Mesh scale=1 m"}),
            "FILE: its surface 'bore' lies 10.9719 to 11.025" + not_the_bore + "1 m right?");
  EXPECT_EQ(
      refusal(FileCase("Die mesh file", die()), {"Tooling/Bore diameter=22.3 mm"}).substr(0, 50),
      "FILE: its surface 'bore' lies 0.0109719 to 0.01102");
  // 0.2 mm beside the axis
  EXPECT_EQ(refusal(FileCase("Die mesh file", shifted(die(), {2e-4, 0, 0}))).substr(0, 44),
            "FILE: its surface 'bore' lies 0.0107729 to 0");
  EXPECT_EQ(refusal(FileCase("Die mesh file", shifted(die(), {0, 0, 5e-3}))),
            "FILE: its bore reaches from z = 0.005 m to 0.025 m (the powder stands from 0 to "
            "Powder/Fill height = 0.02 m). Move the drawing's origin?");
  EXPECT_EQ(refusal(FileCase("Die mesh file", die()), {"Powder/Fill height=21 mm"}),
            "FILE: its bore reaches from z = 0 m to 0.02 m (the powder stands from 0 to "
            "Powder/Fill height = 0.021 m). Move the drawing's origin?");
}

TEST(ElasticMeshes, OfPunchesThatDoNotFitTheBoreAreRefused) {
  auto const upper = [](continuum::HexMesh const& mesh) {
    return refusal(FileCase("Upper punch mesh file", mesh));
  };
  std::string const of_diameter =
      " the die of Tooling/Bore diameter = 0.02205 m). Is Mesh scale = 0.001 m right?";
  EXPECT_EQ(upper(punch(PunchPlace::upper, 12e-3)),
            "FILE: its surface 'face' reaches 0.012 m from the z axis (a punch so wide overlaps" +
                of_diameter);
  EXPECT_EQ(upper(punch(PunchPlace::upper, 10e-3)),
            "FILE: its surface 'face' reaches 0.01 m from the z axis (a punch so narrow leaves a "
            "gap to" +
                of_diameter);
  EXPECT_EQ(upper(shifted(punch(PunchPlace::upper), {0, 0, 1e-3})),
            "FILE: its surface 'face' stands from z = 0.001 m to 0.001 m (its flat part is at z = "
            "0 in a punch's own frame). Move the drawing's origin?");
  EXPECT_EQ(upper(punch(PunchPlace::lower)),
            "FILE: its surface 'back' stands from z = -0.015 m to -0.015 m (the body of the upper "
            "punch is above its face). Turn the drawing over?");
  EXPECT_EQ(refusal(FileCase("Lower punch mesh file", punch(PunchPlace::upper))).substr(0, 57),
            "FILE: its surface 'back' stands from z = 0.015 m to 0.015");
}

} // namespace
} // namespace coupling
