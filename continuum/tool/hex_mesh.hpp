#pragma once

#include "continuum/tool/tool_shape.hpp"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace continuum {

/// One component of one vertex, held against rigid motion.
struct Pin {
  unsigned vertex;
  int component;
};

/// Which lines and faces follow circles about the z axis.
enum class Rounding { everywhere, on_round_surface };

/// A hexahedral mesh as its generator knows it: who is on which surface follows from the counting,
/// never from coordinates.
struct HexMesh {
  struct Quad {
    std::array<unsigned, 4> vertices; ///< lexicographic
    unsigned surface;
  };

  std::vector<Eigen::Vector3d> vertices = {};      ///< [m]
  std::vector<std::array<unsigned, 8>> cells = {}; ///< lexicographic, right-handed
  std::vector<unsigned> regions = {};              ///< material of each cell
  std::vector<Quad> boundary = {};                 ///< every boundary face once
  std::vector<std::string> surfaces = {};          ///< names
  Rounding rounding = Rounding::everywhere;
  unsigned round_surface = 0; ///< with on_round_surface: the one that lies on a circle
  std::vector<Pin> pins =
      {}; ///< tangential: they hold the rigid motions in the plane, not the breathing
};

/// @throws InvalidInput if a length or a count cannot be built
HexMesh mesh_die(DieShape const& shape, DieCells const& cells);
HexMesh mesh_punch(PunchShape const& shape, PunchCells const& cells);

/// n + 1 points from `from` to `to`, cell sizes a geometric series whose last is `growth` times the
/// first.
std::vector<double> graded(double from, double to, int n, double growth);

} // namespace continuum
