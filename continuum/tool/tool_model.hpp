#pragma once

// The one header with deal.II in it, read by the sources of this folder only.
#include "continuum/tool/hex_mesh.hpp"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <cstdint>

namespace continuum {

/// A face of the boundary in the numbers of the whole mesh.
struct BoundaryFace {
  std::array<std::uint32_t, 9> nodes; ///< as in TraceFace, outward
  std::uint32_t surface;
  std::uint32_t cell;
};

/// Nodes are the degrees of freedom of a scalar FE_Q(2): the displacement component c of node a is
/// unknown 3 a + c. Element and mapping have the same degree: with straight cells a second-order
/// element falls back to second order in u and is fifty times worse on a die.
struct ToolModel {
  explicit ToolModel(HexMesh const& mesh);

  dealii::Triangulation<3> triangulation;
  dealii::MappingQ<3> mapping{2};
  dealii::FE_Q<3> element{2};
  dealii::DoFHandler<3> nodes_of_cells;

  Eigen::Matrix3Xd nodes;                           ///< [m]
  std::vector<std::array<std::uint32_t, 27>> cells; ///< in the element's own numbering
  std::vector<std::uint32_t> regions;               ///< of each cell
  std::uint32_t n_regions = 1;
  std::vector<BoundaryFace> boundary;
  std::vector<std::string> surfaces;
  std::vector<std::pair<std::uint32_t, int>> pins; ///< node, component
  std::uint64_t hash = 0;
};

/// Index of a named surface. @throws InvalidInput if there is none
std::uint32_t surface_index(ToolModel const& model, std::string const& name);

} // namespace continuum
