#pragma once

#include "continuum/tool/elastic_material.hpp"
#include "continuum/tool/tool_shape.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace coupling {

enum class CouplingMode { rigid, one_way, two_way_explicit, two_way_secant, two_way_implicit };
enum class Accelerator { aitken, iqn_ils };
/// clamped: a surface held. rollers: held along the axis, and by three pins. guided (punches):
/// clamped at the back, and its side does not leave the axis: the die's bore leads it.
enum class ToolSupport { rollers, clamped, guided };

/// How grains and deformable tools are coupled. See ToolCoupling.
struct CouplingChoice {
  CouplingMode mode = CouplingMode::rigid;
  std::uint64_t window = 100;                     ///< steps
  Accelerator accelerator = Accelerator::iqn_ils; ///< implicit only, like the rest
  double tolerance = 1e-4;                        ///< [1], of the loads
  std::uint64_t most_iterations = 20;
};

/// What deformable tools look like beyond Tooling's dimensions.
struct ElasticToolShapes {
  double ring_thickness = 0.0; ///< [m], of a ring bonded round the die; 0: none
  decltype(continuum::PunchShape::face) punch_face = continuum::FlatFace{}; ///< of both punches
  /// gmsh files that replace a tool's dimensions; empty: none. A punch's face is at z = 0.
  std::filesystem::path die_file, upper_punch_file, lower_punch_file;
  double mesh_scale = 1.0;   ///< [m] per unit of these files
  double largest_gap = 5e-5; ///< [m], between Tooling's STL of a tool and the mesh behind it
};

/// The tools as elastic bodies. Their modulus here is that of the body; the one at a contact is
/// Tooling's.
struct ElasticTools {
  continuum::ElasticMaterial material{.young_modulus = 210e9, .poisson_ratio = 0.3};
  std::optional<continuum::ElasticMaterial> ring = {}; ///< material of the die's second region
  ElasticToolShapes shapes = {};
  double cell_size = 3.5e-3; ///< [m], of the meshes where grains press
  ToolSupport die_support = ToolSupport::clamped, punch_support = ToolSupport::clamped;
  double stress_interval = 0.0; ///< [s], between files of the tools' stress; 0: at the peak only
  CouplingChoice coupling;
};

} // namespace coupling
