#pragma once

#include "continuum/tool/elastic_material.hpp"
#include "continuum/tool/elastic_tool.hpp"
#include "continuum/tool/factor.hpp"
#include "continuum/tool/tool_mesh.hpp"

#include <vector>

namespace continuum {

/// K of the free body [N/m], unknown 3 a + c; its kernel are the six rigid motions.
SparseMatrix assemble_stiffness(ToolModel const& model,
                                std::vector<ElasticMaterial> const& materials);

/// Visits every point of `cells` (all if empty) at the Gauss points, or at the element's nodes.
enum class StressPlaces { gauss_points, nodes };
struct CellStress {
  std::uint32_t cell;
  std::vector<StressPoint>
      points; ///< at the 27 places, in the order of the quadrature or the nodes
};
std::vector<CellStress> cell_stresses(ToolModel const& model,
                                      std::vector<ElasticMaterial> const& materials,
                                      Eigen::Matrix3Xd const& displacement, StressPlaces places);

} // namespace continuum
