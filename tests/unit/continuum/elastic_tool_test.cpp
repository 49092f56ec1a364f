#include "continuum/tool/field_output.hpp"
#include "tests/support/near.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/continuum/tools.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace {

using namespace continuum;
using tools::steel;

// u = c z is zero on the clamped bottom; isoparametric elements hold every linear field, so the
// forces K u bring it back exactly, on curved cells, too.
TEST(PatchTest, ReproducesALinearDisplacement) {
  ElasticTool const tool(tools::small_die(), {steel}, Supports::clamped("bottom"));
  Eigen::Vector3d const c(3e-4, -2e-4, 5e-4);
  Eigen::Matrix3Xd const linear = c * tool.mesh().nodes().row(2);
  auto const solution = tool.solve(tool.internal_forces(linear));
  EXPECT_LT((solution.displacement - linear).norm(), 1e-10 * linear.norm());

  // grad u = c e_z^T:  sigma = lambda c_z I + G (c e_z^T + e_z c^T)
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
  gradient.col(2) = c;
  double const lambda = 210e9 * 0.3 / (1.3 * 0.4), G = 210e9 / 2.6;
  Eigen::Matrix3d const stress =
      lambda * c.z() * Eigen::Matrix3d::Identity() + G * (gradient + gradient.transpose());
  for (StressPoint const& point : tool.stress_in_cells(solution.displacement))
    EXPECT_LT((point.stress - stress).norm(), 1e-9 * stress.norm());
}

TEST(PatchTest, RigidMotionGivesNeitherStressNorForce) {
  ElasticTool const tool(tools::small_punch(), {steel}, Supports::clamped("back"));
  Eigen::Vector3d const shift(1e-3, -2e-3, 3e-3), turn(2e-2, 1e-2, -3e-2);
  Eigen::Matrix3Xd rigid = tool.mesh().nodes();
  for (auto node : rigid.colwise())
    node = (shift + turn.cross(Eigen::Vector3d(node))).eval();
  for (StressPoint const& point : tool.stress_in_cells(rigid))
    EXPECT_LT(point.stress.norm(), 1e-12 * steel.young_modulus);
  EXPECT_LT(tool.internal_forces(rigid).norm(),
            1e-11 * tool.internal_forces(tools::random_forces(rigid.cols(), 1) * 1e-3).norm());
}

// Sides free, back on rollers: uniaxial stress, shortening F L / (E A), the exact solution being
// linear. A is the area of the FE face, which the pressure acts on.
TEST(Punch, ShortensByForceTimesLengthOverStiffness) {
  for (PunchPlace const place : {PunchPlace::lower, PunchPlace::upper}) {
    ElasticTool const tool(tools::small_punch(place), {steel}, Supports::rollers("back"));
    double const pressure = 65.7e6, into_body = place == PunchPlace::lower ? -1.0 : 1.0;
    auto const solution = tool.solve_pressure("face", pressure);
    double const expected = into_body * pressure * 50e-3 / 210e9; // 15.6 um
    for (std::uint32_t const node : tool.mesh().trace("face").nodes)
      EXPECT_TRUE(near::relative(solution.displacement(2, node), expected, 1e-10));
    double const area = tool.mesh().trace("face").area();
    EXPECT_TRUE(
        near::relative(solution.reactions.row(2).sum(), -into_body * pressure * area, 1e-10));
    // Clapeyron: the stored energy is half the load's work.
    EXPECT_TRUE(near::relative(solution.energy, 0.5 * pressure * area * std::abs(expected), 1e-10));
    for (auto const& largest : tool.largest_stress(solution.displacement))
      EXPECT_TRUE(near::relative(largest.point.von_mises(), pressure, 1e-8));
  }
}

TEST(ElasticTool, BalancesForcesAndMomentsOfAnyLoad) {
  ElasticTool const tool(tools::small_die(), {steel}, Supports::clamped("outer"));
  SurfaceTrace const bore = tool.mesh().trace("bore");
  auto const loads = tool.spread(bore, tools::random_forces(bore.nodes.size(), 2));
  auto const solution = tool.solve(loads);
  EXPECT_LT(solution.residual, 1e-12);
  EXPECT_LT(solution.imbalance, 1e-12);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double size = 0.0;
  for (Eigen::Index i = 0; i < loads.cols(); ++i) {
    Eigen::Vector3d const x = tool.mesh().nodes().col(i);
    moment += x.cross(Eigen::Vector3d(loads.col(i) + solution.reactions.col(i)));
    size += x.norm() * loads.col(i).norm();
  }
  EXPECT_LT(moment.norm(), 1e-12 * size);
}

// Pins hold motions that a balanced load does not excite.
TEST(ElasticTool, PinsCarryNothingUnderPressure) {
  ElasticTool const tool(tools::small_die(), {steel}, Supports::rollers("bottom"));
  auto const solution = tool.solve_pressure("bore", 1e6);
  double const force = 1e6 * tool.mesh().trace("bore").area();
  EXPECT_LT(solution.reactions.topRows(2).cwiseAbs().maxCoeff(), 1e-10 * force);
}

TEST(ElasticTool, IsLinearInTheLoadAndSoftensWithTheModulus) {
  ElasticTool const tool(tools::small_die(), {steel}, Supports::clamped("outer"));
  ElasticTool const soft(tools::small_die(), {{.young_modulus = 210e6, .poisson_ratio = 0.3}},
                         Supports::clamped("outer"));
  auto const u = tool.solve_pressure("bore", 1e6).displacement;
  EXPECT_LT((tool.solve_pressure("bore", -3e6).displacement + 3.0 * u).norm(), 1e-12 * u.norm());
  EXPECT_LT((soft.solve_pressure("bore", 1e3).displacement - u).norm(), 1e-12 * u.norm());
  EXPECT_EQ(tool.solve_pressure("bore", 0.0).displacement.norm(), 0.0);
}

TEST(ElasticTool, ReportsTheLargestStressWithPlaceAndUtilisation) {
  ElasticMaterial hard = steel;
  hard.yield_strength = 2e9;
  hard.fatigue_strength = 8e8;
  ElasticTool const tool(tools::small_die(), {hard}, tools::plane_strain());
  auto const largest = tool.largest_stress(tool.solve_pressure("bore", 65.7e6).displacement).at(0);
  // Lame: 131.628 MPa, at the bore; this coarse mesh is 7 % off.
  EXPECT_TRUE(near::relative(largest.point.von_mises(), 131.628e6, 0.08));
  EXPECT_TRUE(near::relative(largest.point.position.head<2>().norm(), tools::a, 1e-3));
  EXPECT_DOUBLE_EQ(*largest.yield_utilisation, largest.point.von_mises() / 2e9);
  EXPECT_DOUBLE_EQ(*largest.fatigue_utilisation, largest.point.von_mises() / 8e8);
}

// Uniaxial 3 MPa and pure shear of 1 MPa: von Mises 3 and sqrt(3) MPa.
TEST(Stress, HasItsInvariants) {
  Eigen::Matrix3d uniaxial = Eigen::Matrix3d::Zero(), shear = Eigen::Matrix3d::Zero();
  uniaxial(2, 2) = 3e6;
  shear(0, 1) = shear(1, 0) = 1e6;
  EXPECT_DOUBLE_EQ(von_mises(uniaxial), 3e6);
  EXPECT_DOUBLE_EQ(von_mises(shear), std::sqrt(3.0) * 1e6);
  EXPECT_TRUE(principal_stresses(shear).isApprox(Eigen::Vector3d(1e6, 0.0, -1e6), 1e-12));
}

TEST(FieldOutput, WritesDisplacementAndStresses) {
  support::ScratchFolder const folder;
  ElasticTool const tool(tools::small_die(), {steel}, Supports::rollers("bottom"));
  auto const file = folder.path() / "die.vtu";
  write_vtu(file, tool, tool.solve_pressure("bore", 1e6).displacement);
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  for (std::string const name : {"displacement", "stress", "von_mises", "principal_stresses"})
    EXPECT_NE(text.str().find("Name=\"" + name + "\""), std::string::npos) << name;
  EXPECT_NE(text.str().find("</VTKFile>"), std::string::npos);
}

} // namespace
