// Each bad input has its message: what, the value, why, and a way out.
#include "continuum/session.hpp"
#include "continuum/tool/interface_compliance.hpp"
#include "tests/unit/continuum/refusal.hpp"
#include "tests/unit/continuum/tools.hpp"

#include <limits>

namespace {

using namespace continuum;
using tools::steel;

void expect_refused_die(DieShape const& shape, DieCells const& cells, std::string const& part) {
  expect_refusal([&] { ToolMesh::die(shape, cells); }, part);
}

TEST(Refusal, OfDies) {
  DieShape const good{.bore_radius = 11e-3, .outer_radius = 30e-3, .height = 20e-3};
  DieShape shape = good;
  shape.bore_radius = -11e-3;
  expect_refused_die(shape, {}, "bore radius = -0.011 m");
  shape = good;
  shape.outer_radius = 10e-3;
  expect_refused_die(shape, {}, "outer radius = 0.01 m is not beyond the bore radius = 0.011 m");
  shape = good;
  shape.height = std::numeric_limits<double>::quiet_NaN();
  expect_refused_die(shape, {}, "height = nan m");
  shape = good;
  shape.ring_radius = 30e-3;
  expect_refused_die(shape, {}, "ring radius = 0.03 m is not beyond the outer radius");
  expect_refused_die(good, {.around = 30},
                     "cells around = 30 (a multiple of 4, up to 4096). Take 32?");
  expect_refused_die(good, {.through_wall = 0}, "cells through the wall = 0");
  expect_refused_die(good, {.along = -1}, "cells along = -1");
  expect_refused_die(good, {.growth = 0.0}, "growth of cells = 0");
}

TEST(Refusal, OfPunches) {
  expect_refusal([] { ToolMesh::punch({.radius = 0.0, .length = 1.0}, {}); }, "radius = 0 m");
  expect_refusal([] { ToolMesh::punch({.radius = 1.0, .length = -1.0}, {}); }, "length = -1 m");
  expect_refusal([] { ToolMesh::punch({.radius = 1.0, .length = 1.0}, {.around = 12}); },
                 "Take 16?");
  expect_refusal([] { cells_of_size(PunchShape{.radius = 1.0, .length = 1.0}, 0.0); },
                 "element size = 0 m");
}

TEST(Refusal, OfPunchFaces) {
  auto const refuse = [](decltype(PunchShape::face) const& face, std::string const& part,
                         int rim = 2) {
    expect_refusal(
        [&] { ToolMesh::punch({.radius = 11e-3, .length = 5e-3, .face = face}, {.rim = rim}); },
        part);
  };
  refuse(BevelledFace{.width = 0.0, .depth = 1e-3}, "bevel width = 0 m");
  refuse(BevelledFace{.width = 11e-3, .depth = 1e-3},
         "bevel width = 0.011 m is not between 0 and the radius = 0.011 m");
  refuse(BevelledFace{.width = 1e-3, .depth = 0.0}, "bevel depth = 0 m");
  refuse(BevelledFace{.width = 1e-3, .depth = 5e-3}, "bevel depth = 0.005 m");
  refuse(BevelledFace{.width = 1e-3, .depth = -5e-3}, "bevel depth = -0.005 m");
  refuse(BevelledFace{.width = 1e-3, .depth = std::numeric_limits<double>::quiet_NaN()},
         "bevel depth = nan m");
  refuse(ConcaveFace{.depth = 0.0}, "cup depth = 0 m");
  refuse(ConcaveFace{.depth = 10e-3, .land = 1e-3},
         "cup depth = 0.01 m is not between 0 and the opening radius = 0.01 m");
  refuse(ConcaveFace{.depth = 6e-3}, "cup depth = 0.006 m reaches the back at 0.005 m");
  refuse(ConcaveFace{.depth = 1e-3, .land = 11e-3}, "land = 0.011 m");
  refuse(ConcaveFace{.depth = 1e-3, .land = -1e-3}, "land = -0.001 m");
  refuse(ConcaveFace{.depth = 1e-3, .land = 1e-3}, "cells in rings of the rim = 0", 0);
}

TEST(Refusal, OfMaterials) {
  auto const refuse = [](ElasticMaterial const& material, std::string const& part) {
    expect_refusal([&] { material.validate("die"); }, part);
  };
  refuse({.young_modulus = -210e9, .poisson_ratio = 0.3}, "die: Young's modulus = -2.1e+11 Pa");
  refuse({.young_modulus = 210e9, .poisson_ratio = 0.5}, "Poisson's ratio = 0.5");
  refuse({.young_modulus = 210e9, .poisson_ratio = -1.0}, "Poisson's ratio = -1");
  refuse({.young_modulus = 210e9, .poisson_ratio = 0.3, .yield_strength = 0.0},
         "yield strength = 0 Pa");
  refuse({.young_modulus = 210e9, .poisson_ratio = 0.3, .fatigue_strength = -1.0},
         "fatigue strength = -1 Pa");
  expect_refusal(
      [] {
        ElasticTool(tools::small_die(), {steel, steel}, Supports::clamped("outer"));
      },
      "1 regions and 2 materials");
}

TEST(Refusal, OfSupports) {
  auto const refuse = [](Supports const& supports, std::string const& part) {
    expect_refusal([&] { ElasticTool(tools::small_die(), {steel}, supports); }, part);
  };
  refuse({}, "no support");
  refuse(Supports::clamped("botom"),
         "surface 'botom' is not part of the tool (it has bore, outer, bottom, top)");
  refuse({.surfaces = {{"bottom", {true, true, false}}}}, "free to shift along z");
  // A flat ring on rollers still slides and turns.
  refuse({.surfaces = {{"bottom", {false, false, true}}}}, "free to ");
  refuse({.in_plane = Supports::InPlane::pinned}, "free to ");
}

TEST(Refusal, OfLoadsAndTolerances) {
  ElasticTool const tool(tools::small_die(), {steel}, Supports::clamped("outer"));
  expect_refusal([&] { tool.solve(Eigen::Matrix3Xd::Zero(3, 7)); }, "loads of 7 nodes");
  Eigen::Matrix3Xd loads = Eigen::Matrix3Xd::Zero(3, tool.mesh().n_nodes());
  loads(1, 3) = std::numeric_limits<double>::quiet_NaN();
  expect_refusal([&] { tool.solve(loads); }, "not finite");
  expect_refusal([&] { tool.mesh().trace("bore").triangulate(0.0); }, "chord tolerance = 0 m");
  expect_refusal([&] { tool.mesh().trace("bore").triangulate(1e-12); }, "more than 64 x 64");
  expect_refusal([&] { InterfaceCompliance::condense(tool, "outer"); }, "held in all components");
  expect_refusal([&] { InterfaceCompliance::condense(tool, "bor"); }, "surface 'bor' is not part");
}

TEST(Refusal, OfASecondSession) {
  expect_refusal([] { Session second; }, "a second continuum::Session");
}

} // namespace
