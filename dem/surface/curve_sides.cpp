#include "dem/surface/smooth_patches.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

Vec3 maxs_share(TriangleSurface const& surface, std::uint32_t triangle, std::uint32_t vertex) {
  auto const& corners = surface.triangles[triangle];
  auto const k = std::ranges::find(corners, vertex) - corners.begin();
  Vec3 const e1 = surface.vertices[corners[(k + 1) % 3]] - surface.vertices[vertex];
  Vec3 const e2 = surface.vertices[corners[(k + 2) % 3]] - surface.vertices[vertex];
  return e1.cross(e2) / (e1.squaredNorm() * e2.squaredNorm());
}

Vec3 mean_normal(TriangleSurface const& surface, SurfaceEdges const& edges,
                 SmoothPatches const& patches, std::uint32_t patch, std::uint32_t vertex) {
  Vec3 sum = Vec3::Zero();
  for (auto const t : edges.around(vertex))
    if (patches.of_triangle[t] == patch)
      sum += maxs_share(surface, t, vertex);
  return sum.normalized();
}

/// How far a side stands off its chord, and where to: one side's view of an edge.
struct Rise {
  Vec3 normal;   // unit, square to the chord
  double height; // [m], along `normal`
};

/// Height of the arc that leaves its chord d by the angle phi at both ends:  |d|/2 tan(phi/2).
/// The antisymmetric part of the end normals (an inflexion) is left out: it has no arc.
Rise rise_of(Vec3 const& chord, Vec3 const& normal_a, Vec3 const& normal_b) {
  constexpr double steepest = 0.5;
  double const length = chord.norm();
  double const sine =
      std::clamp((normal_b - normal_a).dot(chord) / (2.0 * length), -steepest, steepest);
  Vec3 const mean = normal_a + normal_b;
  return {.normal = (mean - mean.dot(chord) / (length * length) * chord).normalized(),
          .height = 0.5 * length * sine / (1.0 + std::sqrt(1.0 - sine * sine))};
}

/// The offset that has the height of both sides: v = alpha m + beta n with v.m and v.n given.
Vec3 on_both(Rise const& m, Rise const& n) {
  double const g = m.normal.dot(n.normal);
  double const determinant = 1.0 - g * g;
  if (determinant < 0.05)
    return 0.5 * (m.height * m.normal + n.height * n.normal); // the same patch on both sides
  return ((m.height - g * n.height) * m.normal + (n.height - g * m.height) * n.normal) /
         determinant;
}

double lowest_height(TriangleSurface const& surface, SurfaceEdge const& edge, double length) {
  double lowest = area_vector(surface, edge.triangles[0]).norm() / length;
  if (!edge.is_open())
    lowest = std::min(lowest, area_vector(surface, edge.triangles[1]).norm() / length);
  return lowest;
}

Vec3 bulge_of(TriangleSurface const& surface, SurfaceEdge const& edge,
              std::vector<std::array<Vec3, 3>> const& normals) {
  Vec3 const chord = surface.vertices[edge.vertices[1]] - surface.vertices[edge.vertices[0]];
  auto const& first = normals[edge.triangles[0]];
  auto const rise = rise_of(chord, first[edge.sides[0]], first[(edge.sides[0] + 1) % 3]);
  Vec3 bulge = rise.height * rise.normal;
  if (!edge.is_open()) {
    auto const& second = normals[edge.triangles[1]]; // runs the other way
    bulge = on_both(rise, rise_of(chord, second[(edge.sides[1] + 1) % 3], second[edge.sides[1]]));
  }
  // A bulge that a needle cannot hold would fold it over.
  double const limit = 0.2 * lowest_height(surface, edge, chord.norm());
  return bulge.norm() > limit ? Vec3(bulge * (limit / bulge.norm())) : bulge;
}

} // namespace

std::vector<std::array<Vec3, 3>> corner_normals(TriangleSurface const& surface,
                                                SurfaceEdges const& edges,
                                                SmoothPatches const& patches) {
  std::vector<std::array<Vec3, 3>> normals(surface.triangles.size());
  for (std::uint32_t t = 0; t < normals.size(); ++t) {
    auto const patch_row = patches.of_triangle[t];
    auto const& patch = patches.patches[patch_row];
    for (int k = 0; k < 3; ++k) {
      auto const vertex = surface.triangles[t][k];
      Vec3 const arm = surface.vertices[vertex] - patch.origin;
      switch (patch.kind) {
      case PatchKind::plane:
        normals[t][k] = patch.direction;
        break;
      case PatchKind::cylinder:
        normals[t][k] =
            patch.side * (arm - arm.dot(patch.direction) * patch.direction).normalized();
        break;
      case PatchKind::curved:
        normals[t][k] = mean_normal(surface, edges, patches, patch_row, vertex);
        break;
      }
    }
  }
  return normals;
}

std::vector<CurvedTriangle> curve_sides(TriangleSurface const& surface, SurfaceEdges const& edges,
                                        std::vector<std::array<Vec3, 3>> const& normals) {
  std::vector<CurvedTriangle> curved(surface.triangles.size());
  for (std::uint32_t t = 0; t < curved.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      curved[t].corners[k] = surface.vertices[surface.triangles[t][k]];
      curved[t].bulges[k] = bulge_of(surface, edges.edges()[edges.of_triangle(t)[k]], normals);
      if (!curved[t].bulges[k].isZero(0.0))
        curved[t].is_flat = false;
    }
  return curved;
}

} // namespace dem
