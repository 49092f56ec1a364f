#include "coupling/elastic/stressed_surface.hpp"

#include "tests/unit/coupling/elastic_press.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace coupling;

namespace {

Press press() {
  support::ScratchFolder const scratch;
  return layer::press(scratch, {"Mode=one_way"});
}

/// By the divergence theorem: a closed surface that looks outwards encloses its volume.
double enclosed(StressedSurface const& surface) {
  double volume = 0.0;
  for (auto const& [a, b, c] : surface.triangles)
    volume += surface.vertices[a].dot(surface.vertices[b].cross(surface.vertices[c])) / 6.0;
  return volume;
}

} // namespace

TEST(StressedSurface, EnclosesTheTool) {
  Press const p = press();
  for (std::size_t t = 0; t < p.coupling.n_tools(); ++t) {
    YieldingTool const& tool = p.coupling.tool(t);
    auto const whole = stressed_surface(tool, tool.pressure_loads);
    ASSERT_EQ(whole.von_mises.size(), whole.vertices.size());
    double volume = 0.0;
    for (auto const& point : tool.body.stress_in_cells(
             tool.body.solve(tool.body.spread(tool.surface->trace(), tool.pressure_loads))
                 .displacement))
      volume += point.volume;
    // Flat triangles between nodes cut the corners of a round body.
    EXPECT_NEAR(enclosed(whole), volume, 0.01 * volume) << tool.name;
  }
}

/// A punch that its guide holds sideways is in confined compression everywhere: lateral stress
/// nu / (1 - nu) p, so its von Mises stress is p (1 - 2 nu) / (1 - nu).
TEST(StressedSurface, HasTheStressOfItsLoads) {
  Press const p = press();
  ASSERT_EQ(p.setup.elastic.punch_support, ToolSupport::guided);
  YieldingTool const& punch = p.coupling.tool(1);
  double const pressure = 3e6; // [Pa]
  double const nu = p.setup.elastic.material.poisson_ratio;
  auto const whole = stressed_surface(punch, pressure * punch.pressure_loads);
  for (double const stress : whole.von_mises)
    EXPECT_NEAR(stress, pressure * (1.0 - 2.0 * nu) / (1.0 - nu), 1e-6 * pressure);
  EXPECT_GT(whole.von_mises.size(), 100u);
}
