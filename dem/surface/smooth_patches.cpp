#include "dem/surface/smooth_patches.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dem {

namespace {

/// Disjoint sets; the root of a set is its lowest member.
class Groups {
public:
  explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t root(std::uint32_t member) {
    while (parent_[member] != member)
      member = parent_[member] = parent_[parent_[member]];
    return member;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    std::uint32_t const root_a = root(a), root_b = root(b);
    parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
  }

private:
  std::vector<std::uint32_t> parent_;
};

SmoothPatch recognise(TriangleSurface const& surface, std::span<std::uint32_t const> triangles,
                      double smooth_angle, Recognition recognition) {
  if (recognition == Recognition::nothing)
    return {};
  if (auto const plane = fit_plane(surface, triangles))
    return *plane;
  return fit_cylinder(surface, triangles, smooth_angle).value_or(SmoothPatch{});
}

std::vector<bool> find_rims(TriangleSurface const& surface, SurfaceEdges const& edges,
                            double smooth_angle) {
  double const least = std::cos(smooth_angle);
  std::vector<bool> is_rim;
  for (auto const& edge : edges.edges()) {
    auto const smooth = [&] {
      return area_vector(surface, edge.triangles[0])
                 .normalized()
                 .dot(area_vector(surface, edge.triangles[1]).normalized()) > least;
    };
    is_rim.push_back(edge.is_open() || !smooth());
  }
  return is_rim;
}

} // namespace

SmoothPatches find_smooth_patches(TriangleSurface const& surface, SurfaceEdges const& edges,
                                  double smooth_angle, Recognition recognition) {
  auto const n_triangles = static_cast<std::uint32_t>(surface.triangles.size());
  SmoothPatches result;
  result.edge_is_rim = find_rims(surface, edges, smooth_angle);
  Groups groups(n_triangles);
  for (std::size_t e = 0; e < edges.edges().size(); ++e)
    if (!result.edge_is_rim[e])
      groups.join(edges.edges()[e].triangles[0], edges.edges()[e].triangles[1]);
  for (std::uint32_t t = 0; t < n_triangles; ++t) {
    auto const root = groups.root(t);
    if (root == t)
      result.triangles.emplace_back();
    auto const patch = root == t ? static_cast<std::uint32_t>(result.triangles.size() - 1)
                                 : result.of_triangle[root];
    result.of_triangle.push_back(patch);
    result.triangles[patch].push_back(t);
  }
  for (auto const& triangles : result.triangles)
    result.patches.push_back(recognise(surface, triangles, smooth_angle, recognition));
  return result;
}

} // namespace dem
