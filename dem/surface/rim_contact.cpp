#include "dem/surface/surface_search.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

// What a sharp edge or corner does: it touches a grain only from within its own wedge of
// directions, where no adjoining face is nearer.
namespace dem {

namespace {

/// Slack of a direction test, in radians: two patches must never both leave a grain to the other.
constexpr double slack = 1e-9;

std::uint8_t corner_of(TriangleSurface const& surface, std::uint32_t triangle,
                       std::uint32_t vertex) {
  auto const& corners = surface.triangles[triangle];
  return static_cast<std::uint8_t>(std::ranges::find(corners, vertex) - corners.begin());
}

Vec3 unit_weights(int corner) {
  Vec3 weights = Vec3::Zero();
  weights[corner] = 1.0;
  return weights;
}

/// The direction in the surface of `triangle`, square to its side, that leads inwards from a point
/// of the side.
Vec3 inwards(CurvedTriangle const& triangle, int side, Vec3 const& weights) {
  auto const [xu, xv] = triangle.tangents(weights);
  // Along the side and towards the opposite corner, as directions in (b_1, b_2).
  Vec3 const along = side == 0 ? xu : side == 1 ? Vec3(xv - xu) : Vec3(-xv);
  Vec3 const across = side == 0 ? xv : side == 1 ? Vec3(-xu) : Vec3(xu - xv);
  return across - across.dot(along) / along.squaredNorm() * along;
}

/// Whether going along `direction` from a rim point brings one nearer to the end of `gap`.
bool leads_nearer(Vec3 const& direction, Vec3 const& gap) {
  return direction.dot(gap) > slack * direction.norm() * gap.norm();
}

/// Mean normal about a vertex, weighted with the angles of its triangles: a point near the vertex
/// is inside the body just where it lies behind this normal. Source: Baerentzen and Aanaes, IEEE
/// Trans. Vis. Comput. Graph. 11 (2005) 243.
Vec3 vertex_pseudonormal(TriangleSurface const& surface, SurfaceEdges const& edges,
                         std::uint32_t vertex) {
  Vec3 sum = Vec3::Zero();
  for (auto const t : edges.around(vertex)) {
    auto const k = corner_of(surface, t, vertex);
    auto const& corners = surface.triangles[t];
    Vec3 const e1 = surface.vertices[corners[(k + 1) % 3]] - surface.vertices[vertex];
    Vec3 const e2 = surface.vertices[corners[(k + 2) % 3]] - surface.vertices[vertex];
    Vec3 const area = e1.cross(e2);
    sum += std::atan2(area.norm(), e1.dot(e2)) * area.normalized();
  }
  return sum;
}

bool is_open_at(SurfaceEdges const& edges, std::uint32_t vertex) {
  return std::ranges::any_of(edges.around(vertex), [&](std::uint32_t t) {
    return std::ranges::any_of(edges.of_triangle(t), [&](std::uint32_t e) {
      auto const& edge = edges.edges()[e];
      return edge.is_open() && std::ranges::find(edge.vertices, vertex) != edge.vertices.end();
    });
  });
}

} // namespace

bool SmoothSurface::Search::is_local_minimum(PatchHit const& hit, Vec3 const& centre) const {
  Vec3 const gap = centre - hit.nearest.point;
  if (hit.nearest.feature == Feature::side) {
    auto const& edge = edges.edges()[edges.of_triangle(hit.triangle)[hit.nearest.row]];
    if (edge.is_open())
      return true;
    int const other = edge.triangles[0] == hit.triangle ? 1 : 0;
    auto const t = edge.triangles[other];
    if (smooth.of_triangle[t] == hit.patch)
      return true; // `nearest` has looked there
    int const side = edge.sides[other];
    // The neighbour runs along the side the other way.
    double const s = 1.0 - hit.nearest.weights[(hit.nearest.row + 1) % 3];
    Vec3 weights = Vec3::Zero();
    weights[side] = 1.0 - s;
    weights[(side + 1) % 3] = s;
    return !leads_nearer(inwards(curved[t], side, weights), gap);
  }
  auto const vertex = surface.triangles[hit.triangle][hit.nearest.row];
  return std::ranges::none_of(edges.around(vertex), [&](std::uint32_t t) {
    if (smooth.of_triangle[t] == hit.patch)
      return false;
    auto const k = corner_of(surface, t, vertex);
    auto const [xu, xv] = curved[t].tangents(unit_weights(k));
    Vec3 const one = k == 0 ? xu : k == 1 ? Vec3(xv - xu) : Vec3(-xv);
    Vec3 const two = k == 0 ? xv : k == 1 ? Vec3(-xu) : Vec3(xu - xv);
    return leads_nearer(one, gap) || leads_nearer(two, gap);
  });
}

bool SmoothSurface::Search::is_inside(PatchHit const& hit, Vec3 const& gap) const {
  if (hit.nearest.feature == Feature::corner) {
    auto const vertex = surface.triangles[hit.triangle][hit.nearest.row];
    return !is_open_at(edges, vertex) && vertex_pseudonormal(surface, edges, vertex).dot(gap) < 0.0;
  }
  auto const& edge = edges.edges()[edges.of_triangle(hit.triangle)[hit.nearest.row]];
  if (edge.is_open())
    return false;
  return gap.dot(area_vector(surface, edge.triangles[0]).normalized() +
                 area_vector(surface, edge.triangles[1]).normalized()) < 0.0;
}

SurfacePoint SmoothSurface::Search::rim_point(PatchHit const& hit, Vec3 const& centre) const {
  Vec3 const gap = centre - hit.nearest.point;
  // Behind a concave edge the nearest way out of the body leads through the edge.
  double const side = is_inside(hit, gap) ? -1.0 : 1.0;
  Vec3 normal = side * gap;
  if (!(hit.nearest.distance > 0.0))
    normal = area_vector(surface, hit.triangle);
  return {.point = hit.nearest.point,
          .normal = normal.normalized(),
          .distance = side * hit.nearest.distance,
          .patch = hit.patch,
          .triangle = hit.triangle};
}

} // namespace dem
