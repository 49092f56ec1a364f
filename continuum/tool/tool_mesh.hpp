#pragma once

#include "continuum/tool/hex_mesh.hpp"
#include "continuum/tool/mesh_files.hpp"
#include "continuum/tool/surface_trace.hpp"
#include "continuum/tool/tool_shape.hpp"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace continuum {

struct StlTool;
struct ToolModel; // continuum/tool/tool_model.hpp: its inside, for the sources of this folder

/// A tool as second-order hexahedra (27 nodes, geometry of the same order), with named surfaces:
///   die    bore, outer, bottom, top      punch   face, side, back
/// Nodes on round surfaces lie on the exact cylinder, cone or sphere. Immutable; copies share the
/// mesh.
class ToolMesh {
public:
  /// @throws InvalidInput if the shape or the counts cannot be built, or a cell is inverted
  static ToolMesh die(DieShape const& shape, DieCells const& cells);
  static ToolMesh punch(PunchShape const& shape, PunchCells const& cells);

  /// Any body, its surfaces named by whoever makes the mesh (hex_mesh.hpp).
  /// @param where  what messages call the mesh
  /// @throws InvalidInput if the mesh is empty, torn, open or inverted, or a boundary face has no
  ///         surface
  static ToolMesh from_hexes(HexMesh const& mesh, std::string const& where = "tool mesh");

  /// A gmsh file (.msh 2.2 or 4.1, text or binary) of hexahedra with 8, 20 or 27 nodes. Those of
  /// first order get straight sides, those of 20 nodes the middles of serendipity faces. Physical
  /// surfaces are the named surfaces and cover the boundary; physical volumes are the regions, in
  /// the order of their numbers. There are no pins: Supports::surfaces and nodes hold such a tool.
  /// @throws InvalidInput naming the file: if it is missing or no mesh, has other elements, no
  ///         physical surfaces or not those required, and as from_hexes
  static ToolMesh from_msh(std::filesystem::path const& file, MshOptions const& options = {});

  /// A closed STL: parted into patches along its sharp edges, named by the shapes of the options,
  /// meshed anew with tetrahedra by gmsh, each cut into four hexahedra. Between its nodes the new
  /// skin leaves the STL's facets by their sagitta; how far is measured both ways. No pins.
  /// @throws InvalidInput naming the file: if it is missing, no STL or not closed, if a patch has
  /// no
  ///         name, if the gap exceeds its tolerance, or with gmsh's own message
  static StlTool from_stl(std::filesystem::path const& file, StlOptions const& options);

  std::vector<std::string> const& surfaces() const;
  std::size_t n_cells() const;
  std::size_t n_nodes() const;
  std::size_t n_regions() const; ///< each takes a material: 0 the wall, 1 the ring

  Eigen::Matrix3Xd const& nodes() const; ///< positions [m], 3 x n_nodes
  /// Of a cell: 9 k + 3 j + i stands at (i/2, j/2, k/2) of it.
  std::array<std::uint32_t, 27> cell_nodes(std::size_t cell) const;
  std::uint32_t region(std::size_t cell) const;

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

/// A tool from an STL.
struct StlTool {
  ToolMesh mesh;
  double largest_gap; ///< between STL and FE boundary [m]
};

} // namespace continuum
