#include "continuum/errors.hpp"
#include "continuum/tool/interface_compliance.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/continuum/tools.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

namespace {

using namespace continuum;
using tools::steel;

ElasticTool clamped_die() {
  return ElasticTool(tools::small_die(), {steel}, Supports::clamped("outer"));
}

Eigen::Matrix3Xd on_surface(Eigen::Matrix3Xd const& field, SurfaceTrace const& trace) {
  Eigen::Matrix3Xd values(3, trace.nodes.size());
  for (std::size_t i = 0; i < trace.nodes.size(); ++i)
    values.col(i) = field.col(trace.nodes[i]);
  return values;
}

void expect_equal_to_full_solve(ElasticTool const& tool, std::string const& surface) {
  SurfaceTrace const trace = tool.mesh().trace(surface);
  auto const compliance = InterfaceCompliance::condense(tool, surface);
  std::vector<Eigen::Matrix3Xd> loads = {trace.pressure_loads(65.7e6)};
  for (unsigned seed = 1; seed <= 3; ++seed)
    loads.push_back(tools::random_forces(trace.nodes.size(), seed));
  loads.push_back(Eigen::Matrix3Xd::Zero(3, trace.nodes.size()));
  loads.back()(0, 5) = 1.0; // a column of C
  for (auto const& forces : loads) {
    auto const full = on_surface(tool.solve(tool.spread(trace, forces)).displacement, trace);
    EXPECT_LT((compliance.displacement(forces) - full).norm(), 1e-10 * full.norm());
  }
}

TEST(InterfaceCompliance, IsTheFullSolveOnTheSurface) {
  expect_equal_to_full_solve(clamped_die(), "bore");
  expect_equal_to_full_solve(ElasticTool(tools::small_punch(), {steel}, Supports::clamped("back")),
                             "face");
}

// Rollers hold nodes of the bore's lower rim: they move nowhere, whatever acts on them.
TEST(InterfaceCompliance, RespectsSupportsOnItsSurface) {
  ElasticTool const tool(tools::small_die(), {steel}, Supports::rollers("bottom"));
  expect_equal_to_full_solve(tool, "bore");
  auto const compliance = InterfaceCompliance::condense(tool, "bore");
  auto const nodes = tool.mesh().trace("bore").nodes;
  int n_held = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (tool.is_held()[3 * nodes[i] + 2]) {
      EXPECT_EQ(compliance.matrix().col(3 * i + 2).norm(), 0.0);
      ++n_held;
    }
  EXPECT_EQ(n_held, 32); // 16 cells around, two nodes each
}

TEST(InterfaceCompliance, IsSymmetricAndPositiveDefinite) {
  auto const compliance = InterfaceCompliance::condense(clamped_die(), "bore");
  Eigen::MatrixXd const& C = compliance.matrix();
  EXPECT_EQ((C - C.transpose()).norm(), 0.0);
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> const modes(C, Eigen::EigenvaluesOnly);
  EXPECT_GT(modes.eigenvalues().minCoeff(), 0.0);
}

TEST(InterfaceCompliance, SurvivesItsFileToTheBit) {
  support::ScratchFolder const folder;
  ElasticTool const tool = clamped_die();
  auto const made = InterfaceCompliance::cached(tool, "bore", folder.path());
  auto const n_files = std::distance(std::filesystem::directory_iterator(folder.path()), {});
  EXPECT_EQ(n_files, 1); // nothing temporary is left
  auto const read = InterfaceCompliance::cached(tool, "bore", folder.path());
  EXPECT_TRUE(made.matrix() == read.matrix());
  EXPECT_EQ(made.key(), read.key());
}

std::string refusal(std::filesystem::path const& file, std::uint64_t key) {
  try {
    InterfaceCompliance::load(file, key);
  } catch (InvalidInput const& error) {
    return error.what();
  }
  return "taken";
}

TEST(InterfaceCompliance, RefusesDamagedAndForeignFiles) {
  support::ScratchFolder const folder;
  auto const file = folder.path() / "c.h5";
  auto const compliance = InterfaceCompliance::condense(clamped_die(), "bore");
  compliance.save(file);
  EXPECT_NE(refusal(file, compliance.key() + 1).find("another tool"), std::string::npos);
  EXPECT_NE(refusal(folder.path() / "none.h5", 1).find("no readable HDF5"), std::string::npos);

  std::fstream(file, std::ios::in | std::ios::out | std::ios::binary)
      .seekp(std::filesystem::file_size(file) / 2)
      .put('\x55')
      .put('\x55');
  EXPECT_NE(refusal(file, compliance.key()).find("damaged"), std::string::npos);
  std::filesystem::resize_file(file, 5000);
  EXPECT_NE(refusal(file, compliance.key()), "taken");
  std::ofstream(file) << "solid die\n";
  EXPECT_NE(refusal(file, compliance.key()).find("no readable HDF5"), std::string::npos);
  EXPECT_THROW(compliance.save(folder.path() / "no" / "c.h5"), InvalidInput);
}

TEST(InterfaceCompliance, KeyTellsMaterialSupportsAndSurface) {
  std::set<std::uint64_t> keys;
  keys.insert(InterfaceCompliance::key(clamped_die(), "bore"));
  keys.insert(InterfaceCompliance::key(clamped_die(), "top"));
  for (ElasticMaterial const& material :
       {ElasticMaterial{.young_modulus = 211e9, .poisson_ratio = 0.3},
        ElasticMaterial{.young_modulus = 210e9, .poisson_ratio = 0.31}})
    keys.insert(InterfaceCompliance::key(
        ElasticTool(tools::small_die(), {material}, Supports::clamped("outer")), "bore"));
  keys.insert(InterfaceCompliance::key(
      ElasticTool(tools::small_die(), {steel}, Supports::clamped("bottom")), "bore"));
  EXPECT_EQ(keys.size(), 5u);
}

} // namespace
