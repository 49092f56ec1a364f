#include "dem/surface/surface_report.hpp"

#include "dem/expect.hpp"
#include "dem/surface/surface_edges.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>

namespace dem {

namespace {

double longest_side(TriangleSurface const& surface, std::uint32_t triangle) {
  auto const& corners = surface.triangles[triangle];
  double longest = 0.0;
  for (int k = 0; k < 3; ++k)
    longest = std::max(
        longest, (surface.vertices[corners[(k + 1) % 3]] - surface.vertices[corners[k]]).norm());
  return longest;
}

void refuse_degenerate(TriangleSurface const& surface, std::uint32_t triangle, double diagonal) {
  double const longest = longest_side(surface, triangle);
  double const height =
      area_vector(surface, triangle).norm() / longest; // NaN for a point: refused too
  VALIDATE(height > smallest_triangle_height * diagonal,
           surface.name + ": triangle " + std::to_string(std::uint64_t{triangle} + 1) +
               " is degenerate (its corners lie on one line, so it has no normal). Remove it?");
}

} // namespace

SurfaceReport inspect_surface(TriangleSurface const& surface) {
  VALIDATE(!surface.triangles.empty(),
           surface.name + ": the surface has no triangles. Is it the right file?");
  SurfaceReport report{.n_vertices = surface.vertices.size(),
                       .n_triangles = surface.triangles.size()};
  report.low = report.high = surface.vertices.front();
  for (auto const& vertex : surface.vertices) {
    report.low = report.low.cwiseMin(vertex);
    report.high = report.high.cwiseMax(vertex);
  }
  Vec3 const centre =
      0.5 * (report.low + report.high); // volumes about it lose no digits far from the origin
  double const diagonal = (report.high - report.low).norm();
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    refuse_degenerate(surface, t, diagonal);
    Vec3 const area = area_vector(surface, t);
    report.area += 0.5 * area.norm();
    report.volume += (surface.vertices[surface.triangles[t][0]] - centre).dot(area) / 6.0;
  }
  report.n_open_edges = SurfaceEdges(surface).n_open();
  report.closed = report.n_open_edges == 0;
  if (!report.closed)
    report.volume = 0.0;
  return report;
}

} // namespace dem
