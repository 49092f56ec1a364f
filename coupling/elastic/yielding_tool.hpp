#pragma once

#include "continuum/tool/elastic_tool.hpp"
#include "continuum/tool/interface_compliance.hpp"
#include "coupling/case.hpp"
#include "coupling/elastic/elastic_surface.hpp"
#include "dem/surface/tool.hpp"

#include <memory>
#include <string>
#include <vector>

namespace coupling {

/// A tool of the press as an elastic body: what grains touch is the trace of its FE mesh, or an STL
/// within a stated gap of it.
/// Immutable but for the course of its surface.
struct YieldingTool {
  std::string name;    ///< "die", "upper_punch", "lower_punch"
  std::string pressed; ///< the surface that grains press: "bore" or "face"
  continuum::ElasticTool body;
  continuum::InterfaceCompliance compliance; ///< on that surface
  std::shared_ptr<ElasticSurface> surface;
  dem::Vec3 offset; ///< [m], from the frame of the mesh to the tool's own

  Eigen::Matrix3Xd pressure_loads; ///< P of 1 Pa on the surface [m^2]: they point into the body
  double area;                     ///< [m^2]
  double uniform_compliance = 0.0; ///< [m/N], retreat over force under a uniform pressure
  double gap = 0.0;                ///< [m], see largest_gap()

  /// Mean displacement into the body over the surface [m]: P.u / A.
  double retreat(Eigen::Matrix3Xd const& displacement) const;
  /// Sum of the components into the body [N].
  double pressing_force(Eigen::Matrix3Xd const& forces) const;
};

/// A tool that grains touch, and the body behind it.
struct ElasticPair {
  dem::SmoothSurface touched; ///< the whole tool as triangles, where it stands at rest
  std::shared_ptr<YieldingTool const> body;
};

/// The press's die, upper and lower punch (in this order) from the case's dimensions, mesh files or
/// STL files (tool_meshes.hpp); operators are read from the user's cache folder where they are.
/// @throws dem::InvalidInput  if a tool cannot be meshed or held, or does not fit the press
std::vector<ElasticPair> make_yielding_tools(Case const& setup);

/// Largest distance between the FE surface and the shape that grains follow on it [m], at Gauss
/// points: facets of a round surface are recognised as what they tessellate.
/// @param offset  [m], from the frame of the mesh to that of what grains touch
double largest_gap(dem::SmoothSurface const& touched, ElasticSurface const& surface,
                   dem::Vec3 const& offset);

} // namespace coupling
