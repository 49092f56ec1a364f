#include "coupling/elastic/tool_stress.hpp"

#include "continuum/tool/field_output.hpp"

#include <algorithm>
#include <cmath>

namespace coupling {
namespace {

constexpr double same_stress = 0.05; // of the largest von Mises stress

double lucy(double q) {
  return q < 1.0 ? (1.0 + 3.0 * q) * std::pow(1.0 - q, 3) : 0.0;
}

std::vector<continuum::StressPoint> stress_under(YieldingTool const& tool,
                                                 Eigen::Matrix3Xd const& loads) {
  auto const all = tool.body.spread(tool.surface->trace(), loads);
  return tool.body.stress_in_cells(tool.body.solve(all).displacement);
}

/// Distance from the pressed surface [m]: into a punch along the axis, into a die along the radius.
double depth_of(YieldingTool const& tool, dem::Vec3 const& point) {
  auto const& positions = tool.surface->trace().positions;
  if (tool.pressed == "bore")
    return std::hypot(point.x(), point.y()) - positions.topRows<2>().colwise().norm().minCoeff();
  bool const is_upper = tool.name == "upper_punch";
  return is_upper ? point.z() - positions.row(2).minCoeff()
                  : positions.row(2).maxCoeff() - point.z();
}

} // namespace

Eigen::Matrix3Xd smoothed(continuum::SurfaceTrace const& trace, Eigen::Matrix3Xd const& loads,
                          double width) {
  auto const& x = trace.positions;
  Eigen::Matrix3Xd spread = Eigen::Matrix3Xd::Zero(3, loads.cols());
  for (Eigen::Index b = 0; b < loads.cols(); ++b) {
    if (loads.col(b).isZero(0.0))
      continue;
    Eigen::ArrayXd const weight =
        ((x.colwise() - x.col(b)).colwise().norm().transpose().array() / width).unaryExpr(&lucy);
    spread += loads.col(b) * (weight / weight.sum()).matrix().transpose();
  }
  return spread;
}

ToolSummary tool_stress(YieldingTool const& tool, Eigen::Matrix3Xd const& loads, double cell_size) {
  ToolSummary summary;
  summary.name = tool.name;
  if (loads.isZero(0.0))
    return summary;
  auto const& trace = tool.surface->trace();
  auto const solution = tool.body.solve(tool.body.spread(trace, loads));
  for (auto const& largest : tool.body.largest_stress(solution.displacement)) {
    double const stress = largest.point.von_mises();
    if (stress <= summary.max_von_mises) // false while none is known
      continue;
    summary.max_von_mises = stress;
    summary.where = largest.point.position + tool.offset;
    if (largest.yield_utilisation)
      summary.yield_utilisation = *largest.yield_utilisation;
  }
  auto const once = stress_under(tool, smoothed(trace, loads, cell_size));
  auto const twice = stress_under(tool, smoothed(trace, loads, 2.0 * cell_size));
  double deepest = 0.0;
  for (std::size_t k = 0; k < once.size(); ++k)
    if (std::abs(once[k].von_mises() - twice[k].von_mises()) > same_stress * summary.max_von_mises)
      deepest = std::max(deepest, depth_of(tool, once[k].position));
  summary.valid_below_depth = deepest;
  return summary;
}

void write_tool_stress(std::filesystem::path const& file, YieldingTool const& tool,
                       Eigen::Matrix3Xd const& loads) {
  auto const all = tool.body.spread(tool.surface->trace(), loads);
  continuum::write_vtu(file, tool.body, tool.body.solve(all).displacement);
}

} // namespace coupling
