#pragma once

#include "continuum/tool/hex_mesh.hpp"

#include <cstdint>
#include <memory>
#include <utility>

// Named only: a source that looks into them includes deal.II itself.
namespace dealii {
template <int, int> class Triangulation;
template <int, int> class MappingQ;
template <int, int> class FE_Q;
template <int, int> class DoFHandler;
} // namespace dealii

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
  /// @param where  what messages call the mesh
  explicit ToolModel(HexMesh const& mesh, std::string const& where = "tool mesh");
  ~ToolModel();

  dealii::Triangulation<3, 3> const& triangulation() const;
  dealii::MappingQ<3, 3> const& mapping() const;
  dealii::FE_Q<3, 3> const& element() const;
  dealii::DoFHandler<3, 3> const& nodes_of_cells() const;

  Eigen::Matrix3Xd nodes;                           ///< [m]
  std::vector<std::array<std::uint32_t, 27>> cells; ///< in the element's own numbering
  std::vector<std::uint32_t> regions;               ///< of each cell
  std::uint32_t n_regions = 1;
  std::vector<BoundaryFace> boundary;
  std::vector<std::string> surfaces;
  std::vector<std::pair<std::uint32_t, int>> pins; ///< node, component
  std::uint64_t hash = 0;

private:
  struct Discretisation; // deal.II's objects
  std::unique_ptr<Discretisation const> discretisation_;
};

/// Index of a named surface. @throws InvalidInput if there is none
std::uint32_t surface_index(ToolModel const& model, std::string const& name);

} // namespace continuum
