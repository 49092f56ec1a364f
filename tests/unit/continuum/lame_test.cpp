// Thick-walled tubes against Lame's closed form.
#include "tests/support/near.hpp"
#include "tests/unit/continuum/tools.hpp"

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace continuum;
using tools::a, tools::b, tools::steel, tools::Tube;

constexpr double p = 65.7e6;

struct Errors {
  double u, stress; // relative: largest nodal error of u, L2 of the stress
  double at_bore;   // mean radial displacement [m]
  double mises;     // mean at the bore [Pa]
};

Errors errors_of(int refinement) {
  int const n = 1 << refinement;
  ElasticTool const tool(
      ToolMesh::die({.bore_radius = a, .outer_radius = b, .height = 5e-3},
                    {.around = 8 * n, .through_wall = 2 * n, .along = 1, .growth = 1.0}),
      {steel}, tools::plane_strain());
  Tube const tube{a, b, p, 0.0, steel};
  auto const u = tool.solve_pressure("bore", p).displacement;

  Errors errors{};
  for (Eigen::Index i = 0; i < u.cols(); ++i) {
    Eigen::Vector3d const x = tool.mesh().nodes().col(i);
    double const r = x.head<2>().norm();
    Eigen::Vector3d const exact = tube.displacement(r) / r * Eigen::Vector3d(x.x(), x.y(), 0.0);
    errors.u = std::max(errors.u, (u.col(i) - exact).norm() / tube.displacement(a));
  }
  double wrong = 0.0, all = 0.0;
  for (StressPoint const& point : tool.stress_in_cells(u)) {
    Eigen::Matrix3d const exact = tube.stress(point.position);
    wrong += point.volume * (point.stress - exact).squaredNorm();
    all += point.volume * exact.squaredNorm();
  }
  errors.stress = std::sqrt(wrong / all);
  auto const bore = tool.stress_on("bore", u);
  auto const nodes = tool.mesh().trace("bore").nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    errors.at_bore += tools::radial(bore[i].position, u.col(nodes[i])) / nodes.size();
    errors.mises += bore[i].von_mises() / nodes.size();
  }
  return errors;
}

// Second-order elements on second-order cells: at least order 3 in u (4 at the nodes of so regular
// a mesh) and 2 in stress. Straight cells would give 2 in u, a wrong Lame constant no convergence
// at all.
TEST(LameTube, ConvergesWithOrderThreeAndTwo) {
  Errors const coarse = errors_of(1), middle = errors_of(2), fine = errors_of(3);
  EXPECT_GE(0.5 * std::log2(coarse.u / fine.u), 2.9);
  EXPECT_GE(0.5 * std::log2(coarse.stress / fine.stress), 1.9);
  EXPECT_GE(std::log2(middle.stress / fine.stress), 1.95); // closer to 2 on finer meshes
  EXPECT_LT(fine.u, 3e-6);
  EXPECT_LT(fine.stress, 2.5e-3);
  // Reference values at 65.7 MPa: u_r(a) = 5.46424 um, von Mises 131.628 MPa.
  EXPECT_TRUE(near::relative(fine.at_bore, 5.46424e-6, 5e-6));
  EXPECT_TRUE(near::relative(fine.mises, 131.628e6, 3e-3));
  RecordProperty("order_of_u", std::to_string(std::log2(middle.u / fine.u)));
  RecordProperty("order_of_stress", std::to_string(std::log2(middle.stress / fine.stress)));
  RecordProperty("error_of_u", std::to_string(fine.u * 1e6) + "e-6");
  RecordProperty("error_of_stress", std::to_string(fine.stress));
  RecordProperty("u_at_bore_um", std::to_string(fine.at_bore * 1e6));
  RecordProperty("von_mises_at_bore_MPa", std::to_string(fine.mises / 1e6));
}

// Ends free to move: u(a) = (p a / E) [ (b^2 + a^2) / (b^2 - a^2) + nu ] = 2.666 um at 30 MPa.
TEST(LameTube, BreathesMoreWithFreeEnds) {
  ElasticTool const tool(ToolMesh::die({.bore_radius = a, .outer_radius = b, .height = 5e-3},
                                       {.around = 32, .through_wall = 6, .along = 1}),
                         {{.young_modulus = 200e9, .poisson_ratio = 0.3}},
                         Supports::rollers("bottom"));
  auto const solution = tool.solve_pressure("bore", 30e6);
  double const expected = 30e6 * a / 200e9 * ((b * b + a * a) / (b * b - a * a) + 0.3); // 2.666 um
  SurfaceTrace const bore = tool.mesh().trace("bore");
  for (std::size_t i = 0; i < bore.nodes.size(); ++i)
    EXPECT_TRUE(near::relative(
        tools::radial(bore.positions.col(i), solution.displacement.col(bore.nodes[i])), expected,
        2e-4));
  EXPECT_TRUE(near::relative(expected, 2.666e-6, 2e-4));
}

// A stiff core in a soft ring: the pressure q between them makes both move alike,
//   u_core(c; p, q) = u_ring(c; q, 0),  linear in q.
TEST(ShrinkFitRing, SharesTheLoadAsTwoBondedTubes) {
  constexpr double c = 18e-3;
  constexpr ElasticMaterial core{.young_modulus = 550e9, .poisson_ratio = 0.22},
      ring{.young_modulus = 110e9, .poisson_ratio = 0.34};
  auto const mismatch = [&](double q) {
    return Tube{a, c, p, q, core}.displacement(c) - Tube{c, b, q, 0.0, ring}.displacement(c);
  };
  double const q = p * mismatch(0.0) / (mismatch(0.0) - mismatch(p));
  Tube const inner{a, c, p, q, core}, outer{c, b, q, 0.0, ring};

  ElasticTool const tool(
      ToolMesh::die(
          {.bore_radius = a, .outer_radius = c, .height = 5e-3, .ring_radius = b},
          {.around = 32, .through_wall = 4, .through_ring = 4, .along = 1, .growth = 1.5}),
      {core, ring}, tools::plane_strain());
  auto const u = tool.solve_pressure("bore", p).displacement;
  for (auto const& [surface, expected] :
       {std::pair{"bore", inner.displacement(a)}, std::pair{"outer", outer.displacement(b)}}) {
    SurfaceTrace const trace = tool.mesh().trace(surface);
    for (std::size_t i = 0; i < trace.nodes.size(); ++i)
      EXPECT_TRUE(near::relative(tools::radial(trace.positions.col(i), u.col(trace.nodes[i])),
                                 expected, 5e-4))
          << surface;
  }
  double wrong = 0.0, all = 0.0;
  for (StressPoint const& point : tool.stress_in_cells(u)) {
    Eigen::Matrix3d const exact = (point.region == 0 ? inner : outer).stress(point.position);
    wrong += point.volume * (point.stress - exact).squaredNorm();
    all += point.volume * exact.squaredNorm();
  }
  EXPECT_LT(std::sqrt(wrong / all), 0.015);
}

} // namespace
