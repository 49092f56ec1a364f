// A die with a shrink-fit ring under forces of single grains, against CalculiX on the same nodes
// with the same nodal forces. Its 20-node bricks lack the nodes in the middle of faces and cells.
// The die stands on rollers and each grain has a partner across, so that nothing is singular but
// the forces: at the edge of a clamp the two elements differ by 0.1 % of the displacement.
#include "tests/crosscode/calculix/deck.hpp"
#include "tests/crosscode/calculix/results.hpp"
#include "tests/crosscode/liggghts/child_process.hpp"
#include "tests/support/near.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <random>

namespace {

using namespace continuum;

constexpr double bore = 11.025e-3, height = 20e-3;
constexpr double powder_from = 3e-3, powder_to = 8e-3; // grains touch the bore there [m]
constexpr double away = 6e-3;                          // from single forces [m]

ElasticTool die() {
  return ElasticTool(
      ToolMesh::die(
          {.bore_radius = bore, .outer_radius = 20e-3, .height = height, .ring_radius = 30e-3},
          {.around = 32, .through_wall = 5, .through_ring = 3, .along = 12}),
      {{.young_modulus = 550e9, .poisson_ratio = 0.22},
       {.young_modulus = 210e9, .poisson_ratio = 0.3}},
      Supports::rollers("bottom"));
}

// The eight shape functions of a serendipity face, in the place of nodes 3 j + i; its middle has
// none. Sides: bubble along times linear across; corners: bilinear less half of both their sides.
Eigen::Matrix<double, 9, 1> serendipity_shape(double xi, double eta) {
  Eigen::Matrix<double, 9, 1> shape = Eigen::Matrix<double, 9, 1>::Zero();
  auto const linear = [](double s, int end) { return end ? s : 1.0 - s; };
  for (int end = 0; end < 2; ++end) {
    shape[6 * end + 1] = 4.0 * xi * (1.0 - xi) * linear(eta, end);
    shape[3 + 2 * end] = 4.0 * eta * (1.0 - eta) * linear(xi, end);
  }
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i)
      shape[6 * j + 2 * i] =
          linear(xi, i) * linear(eta, j) - 0.5 * (shape[6 * j + 1] + shape[3 + 2 * i]);
  return shape;
}

struct GrainLoads {
  Eigen::Matrix3Xd forces; ///< [N], 3 x n_nodes
  std::vector<Eigen::Vector3d> places;
};

// Half a turn about the axis.
Eigen::Vector3d turned(Eigen::Vector3d const& v) {
  return {-v.x(), -v.y(), v.z()};
}

std::uint32_t nearest(Eigen::Matrix3Xd const& positions, Eigen::Vector3d const& x) {
  Eigen::Index node = 0;
  (positions.colwise() - x).colwise().norm().minCoeff(&node);
  return node;
}

// 300 grains at random places of the band press with 5 to 15 N, friction to either side; as many do
// so half a turn on.
GrainLoads grain_loads(ElasticTool const& tool) {
  SurfaceTrace const trace = tool.mesh().trace("bore");
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Eigen::Matrix3Xd on_bore = Eigen::Matrix3Xd::Zero(3, trace.nodes.size());
  std::vector<Eigen::Vector3d> places;
  while (places.size() < 600) {
    auto const face = static_cast<std::uint32_t>(unit(generator) * trace.faces.size());
    double const xi = unit(generator), eta = unit(generator);
    Eigen::Vector3d const x = trace.position(face, xi, eta);
    if (x.z() < powder_from || x.z() > powder_to)
      continue;
    double const size = 5.0 + 10.0 * unit(generator);
    Eigen::Vector3d const friction(0.0, 0.0, 0.4 * (2.0 * unit(generator) - 1.0));
    Eigen::Vector3d const force = size * (friction - trace.normal(face, xi, eta));
    auto const shape = serendipity_shape(xi, eta);
    for (int n = 0; n < 9; ++n) {
      std::uint32_t const node = trace.faces[face].nodes[n];
      on_bore.col(node) += shape[n] * force;
      on_bore.col(nearest(trace.positions, turned(trace.positions.col(node)))) +=
          shape[n] * turned(force);
    }
    places.push_back(x);
    places.push_back(turned(x));
  }
  return {tool.spread(trace, on_bore), places};
}

bool is_away(Eigen::Vector3d const& x, std::vector<Eigen::Vector3d> const& places) {
  return std::ranges::all_of(places, [&](auto const& place) { return (x - place).norm() > away; });
}

struct Comparison {
  ElasticTool tool = die();
  GrainLoads loads = grain_loads(tool);
  ToolSolution ours = tool.solve(loads.forces);
  crosscode::CalculixResults peer = run();

  crosscode::CalculixResults run() const {
    support::ScratchFolder const folder;
    crosscode::write_deck(folder.path() / "die.inp", tool, loads.forces);
    auto const cost = crosscode::run_program(
        {crosscode::find_program("ccx", "calculix-ccx"), "die"}, folder.path());
    if (cost.exit_status != 0)
      throw std::runtime_error("CalculiX failed: " +
                               support::bytes_of(folder.path() / "output.txt"));
    return crosscode::read_results(folder.path() / "die.dat");
  }

  Eigen::Vector3d peer_displacement(std::uint32_t node) const {
    return peer.displacement.at(node + 1);
  }
};

// One run of both codes for all tests, given back before the session of its main ends.
class CalculixDie : public ::testing::Test {
protected:
  static void SetUpTestSuite() { made_ = std::make_unique<Comparison const>(); }
  static void TearDownTestSuite() { made_.reset(); }
  Comparison const& it = *made_;

private:
  static inline std::unique_ptr<Comparison const> made_;
};

std::vector<std::pair<std::string, Eigen::Vector3d>> named_points() {
  double const r = std::sqrt(0.5);
  return {{"bore at the top", {bore, 0.0, height}},
          {"bore above the powder", {0.0, bore, 0.75 * height}},
          {"bore above the powder, across", {-bore * r, bore * r, 0.75 * height}},
          {"outside, top", {30e-3, 0.0, height}},
          {"middle of the wall, top", {0.0, -15.8e-3, height}},
          {"middle of the ring", {18e-3, 18e-3, 0.6 * height}},
          {"middle of the ring, bottom", {-25e-3, 0.0, 0.0}}};
}

std::uint32_t nearest_shared(ToolMesh const& mesh, std::vector<bool> const& shared,
                             Eigen::Vector3d const& place) {
  std::uint32_t nearest = std::ranges::find(shared, true) - shared.begin();
  for (std::uint32_t a = nearest; a < shared.size(); ++a)
    if (shared[a] &&
        (mesh.nodes().col(a) - place).norm() < (mesh.nodes().col(nearest) - place).norm())
      nearest = a;
  return nearest;
}

// The nearest shared node to each name; then all shared nodes away from forces, by their mean
// square.
TEST_F(CalculixDie, MovesAsOurs) {
  auto const& mesh = it.tool.mesh();
  auto const shared = crosscode::is_shared(mesh);
  EXPECT_EQ(it.peer.displacement.size(),
            static_cast<std::size_t>(std::ranges::count(shared, true)));
  near::LargestDeviation named("displacement of named points");
  for (auto const& [name, place] : named_points()) {
    std::uint32_t const node = nearest_shared(mesh, shared, place);
    ASSERT_TRUE(is_away(mesh.nodes().col(node), it.loads.places)) << name;
    Eigen::Vector3d const ours = it.ours.displacement.col(node), peer = it.peer_displacement(node);
    named.add(ours, peer);
    RecordProperty(name, std::to_string(1e6 * ours.norm()) + " um, off by " +
                             std::to_string(1e6 * (ours - peer).norm() / peer.norm()) + "e-6");
  }
  EXPECT_TRUE(named.within(1e-3));
  double wrong = 0.0, all = 0.0;
  int n = 0;
  for (std::size_t a = 0; a < mesh.n_nodes(); ++a)
    if (shared[a] && is_away(mesh.nodes().col(a), it.loads.places)) {
      wrong += (it.ours.displacement.col(a) - it.peer_displacement(a)).squaredNorm();
      all += it.peer_displacement(a).squaredNorm();
      ++n;
    }
  EXPECT_GT(n, 3000);
  EXPECT_LT(std::sqrt(wrong / all), 1e-3);
  RecordProperty("all_nodes_away", std::to_string(1e6 * std::sqrt(wrong / all)) + "e-6");
}

// At the same integration points, 27 a cell in both codes; then all away from forces, by their
// mean square over the volume.
TEST_F(CalculixDie, IsStressedAsOurs) {
  auto const ours = it.tool.stress_in_cells(it.ours.displacement);
  for (auto const& [name, place] : named_points()) {
    std::size_t nearest = 0;
    for (std::size_t q = 0; q < ours.size(); ++q)
      if ((ours[q].position - place).norm() < (ours[nearest].position - place).norm())
        nearest = q;
    auto const& [x, stress] = it.peer.stress.at(nearest / 27 + 1).at(nearest % 27);
    ASSERT_LT((x - ours[nearest].position).norm(), 1e-5) << name;
    double const error = ours[nearest].von_mises() / von_mises(stress) - 1.0;
    RecordProperty(name, std::to_string(ours[nearest].von_mises() / 1e6) + " MPa, off by " +
                             std::to_string(1e6 * error) + "e-6");
    EXPECT_LT(std::abs(error), 0.01) << name;
  }
  double wrong = 0.0, all = 0.0;
  for (std::size_t q = 0; q < ours.size(); ++q)
    if (is_away(ours[q].position, it.loads.places)) {
      double const peer = von_mises(it.peer.stress.at(q / 27 + 1).at(q % 27).second);
      wrong += ours[q].volume * std::pow(ours[q].von_mises() - peer, 2);
      all += ours[q].volume * peer * peer;
    }
  EXPECT_LT(std::sqrt(wrong / all), 0.01);
  RecordProperty("all_points_away", std::to_string(1e6 * std::sqrt(wrong / all)) + "e-6");
}

TEST_F(CalculixDie, RefusesAForceThatThePeerCannotHold) {
  auto const shared = crosscode::is_shared(it.tool.mesh());
  Eigen::Matrix3Xd loads = Eigen::Matrix3Xd::Zero(3, shared.size());
  loads(0, std::ranges::find(shared, false) - shared.begin()) = 1.0;
  support::ScratchFolder const folder;
  EXPECT_THROW(crosscode::write_deck(folder.path() / "die.inp", it.tool, loads),
               std::runtime_error);
}

} // namespace
