#include "dem/surface/surface_search.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace dem {

namespace {

/// The hull of a side's Bezier points: the arc's middle one stands off the chord by twice the
/// bulge.
Box box_of(CurvedTriangle const& triangle, int side) {
  Vec3 const& a = triangle.corners[side];
  Vec3 const& b = triangle.corners[(side + 1) % 3];
  Box box;
  box.include(a);
  box.include(b);
  box.include(0.5 * (a + b) + 2.0 * triangle.bulges[side]);
  return box;
}

/// Holds the curved triangle: the hull of its Bezier points.
Box box_of(CurvedTriangle const& triangle) {
  Box box;
  for (int side = 0; side < 3; ++side)
    box.include(box_of(triangle, side));
  return box;
}

} // namespace

SmoothSurface::Search::Search(TriangleSurface triangle_surface, double smooth_angle,
                              Recognition recognition)
    : surface(std::move(triangle_surface)), edges(surface),
      smooth(find_smooth_patches(surface, edges, smooth_angle, recognition)),
      normals(corner_normals(surface, edges, smooth)), curved(curve_sides(surface, edges, normals)),
      vertex_on_rim(surface.vertices.size(), false), rims(smooth.patches.size()) {
  for (std::uint32_t e = 0; e < edges.edges().size(); ++e) {
    if (!smooth.edge_is_rim[e])
      continue;
    auto const& edge = edges.edges()[e];
    for (auto const vertex : edge.vertices)
      vertex_on_rim[vertex] = true;
    auto const one = smooth.of_triangle[edge.triangles[0]];
    rims[one].push_back(e);
    if (!edge.is_open() && smooth.of_triangle[edge.triangles[1]] != one)
      rims[smooth.of_triangle[edge.triangles[1]]].push_back(e);
  }
  plant_trees();
}

void SmoothSurface::Search::plant_trees() {
  std::vector<Box> patch_boxes, boxes;
  for (std::size_t patch = 0; patch < smooth.patches.size(); ++patch) {
    boxes.clear();
    Box whole;
    for (auto const t : smooth.triangles[patch])
      whole.include(boxes.emplace_back(box_of(curved[t])));
    patch_boxes.push_back(whole);
    triangle_trees.emplace_back(boxes);
    boxes.clear();
    for (auto const e : rims[patch])
      boxes.push_back(box_of(curved[edges.edges()[e].triangles[0]], edges.edges()[e].sides[0]));
    rim_trees.emplace_back(boxes);
  }
  patch_tree = BoxTree(patch_boxes);
}

std::optional<PatchHit> SmoothSurface::Search::nearest(std::uint32_t patch, Vec3 const& centre,
                                                       double reach) const {
  double limit = reach * reach;
  std::optional<PatchHit> best;
  triangle_trees[patch].near(centre, limit, [&](std::uint32_t row) {
    auto const triangle = smooth.triangles[patch][row];
    auto const found = closest_on_curved(curved[triangle], centre);
    if (found.distance > reach || (best && !is_nearer(found, best->nearest)))
      return;
    best = PatchHit{patch, triangle, found, false};
    // Equally near ones must still be seen.
    limit = found.distance * found.distance * (1.0 + 4.0 * equally_near);
  });
  if (best)
    best->on_rim = lies_on_rim(best->triangle, best->nearest);
  return best;
}

bool SmoothSurface::Search::lies_on_rim(std::uint32_t triangle, ClosestPoint const& nearest) const {
  switch (nearest.feature) {
  case Feature::side:
    return smooth.edge_is_rim[edges.of_triangle(triangle)[nearest.row]];
  case Feature::corner:
    return vertex_on_rim[surface.triangles[triangle][nearest.row]];
  case Feature::face:
    break;
  }
  return false;
}

SurfacePoint SmoothSurface::Search::face_point(PatchHit const& hit, Vec3 const& centre) const {
  auto const& patch = smooth.patches[hit.patch];
  SurfacePoint result{.point = hit.nearest.point,
                      .normal = Vec3::Zero(),
                      .distance = 0.0,
                      .patch = hit.patch,
                      .triangle = hit.triangle};
  Vec3 const arm = centre - patch.origin;
  Vec3 const radial = arm - arm.dot(patch.direction) * patch.direction;
  if (patch.kind == PatchKind::plane) {
    result.normal = patch.direction;
    result.distance = arm.dot(patch.direction);
    result.point = centre - result.distance * result.normal;
  } else if (patch.kind == PatchKind::cylinder && radial.norm() > 0.0) {
    result.normal = patch.side * radial.normalized();
    result.distance = patch.side * (radial.norm() - patch.radius);
    result.point = centre - result.distance * result.normal;
  } else {
    auto const& corners = normals[hit.triangle];
    Vec3 const& w = hit.nearest.weights;
    Vec3 const normal = (w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2]).normalized();
    Vec3 const gap = centre - hit.nearest.point;
    double const side = gap.dot(normal) < 0.0 ? -1.0 : 1.0;
    // The way to the nearest point is the normal, until rounding takes its direction.
    bool const has_direction = hit.nearest.distance > 1e-9 * hit.nearest.point.norm();
    result.distance = side * hit.nearest.distance;
    result.normal = has_direction ? Vec3(side / hit.nearest.distance * gap) : normal;
  }
  return result;
}

bool SmoothSurface::Search::is_hidden(SurfacePoint const& contact, Vec3 const& centre) const {
  constexpr double slack = 1e-9;
  Vec3 const way = centre - contact.point;
  Box region;
  region.include(contact.point);
  region.include(centre);
  bool hidden = false;
  auto const leaves_through = [&](std::uint32_t t) {
    Vec3 const area = area_vector(surface, t);
    double const speed = area.dot(way);
    if (speed <= 0.0)
      return false; // enters the body
    auto const& corners = curved[t].corners;
    double const when = area.dot(corners[0] - contact.point) / speed;
    if (when <= slack || when > 1.0 + slack)
      return false;
    Vec3 const through = contact.point + when * way;
    for (int k = 0; k < 3; ++k)
      if (area.dot((corners[(k + 1) % 3] - corners[k]).cross(through - corners[k])) <
          -slack * area.squaredNorm())
        return false;
    return true;
  };
  patch_tree.overlapping(region, [&](std::uint32_t patch) {
    if (hidden)
      return;
    triangle_trees[patch].overlapping(region, [&](std::uint32_t row) {
      hidden = hidden || leaves_through(smooth.triangles[patch][row]);
    });
  });
  return hidden;
}

} // namespace dem
