#pragma once

#include "continuum/tool/surface_trace.hpp"
#include "continuum/tool/tool_shape.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace continuum {

struct ToolModel; // continuum/tool/tool_model.hpp: its inside, for the sources of this folder

/// A tool as second-order hexahedra (27 nodes, geometry of the same order), with named surfaces:
///   die    bore, outer, bottom, top      punch   face, side, back
/// Nodes on round surfaces lie on the exact cylinder. Immutable; copies share the mesh.
class ToolMesh {
public:
  /// @throws InvalidInput if the shape or the counts cannot be built, or a cell is inverted
  static ToolMesh die(DieShape const& shape, DieCells const& cells);
  static ToolMesh punch(PunchShape const& shape, PunchCells const& cells);

  std::vector<std::string> const& surfaces() const;
  std::size_t n_cells() const;
  std::size_t n_nodes() const;
  std::size_t n_regions() const; ///< each takes a material: 0 the wall, 1 the ring

  Eigen::Matrix3Xd const& nodes() const; ///< positions [m], 3 x n_nodes

  /// @throws InvalidInput if the tool has no surface of that name
  SurfaceTrace trace(std::string const& surface) const;
  SurfaceTrace boundary() const; ///< all surfaces as one closed trace

  /// Of positions, cells, regions and names: two meshes agree in it only if they are the same.
  std::uint64_t hash() const;

  ToolModel const& model() const { return *model_; }

private:
  explicit ToolMesh(std::shared_ptr<ToolModel const> model);
  std::shared_ptr<ToolModel const> model_;
};

} // namespace continuum
