#include "dem/surface/smooth_surface.hpp"

#include "dem/expect.hpp"
#include "dem/surface/surface_report.hpp"
#include "dem/surface/surface_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dem {

namespace {

/// Drops rim points that another patch reports as well: of two rims the lower patch keeps it, a
/// face always.
void count_edges_once(std::vector<PatchHit>& hits) {
  auto const same_point = [](PatchHit const& a, PatchHit const& b) {
    return (a.nearest.point - b.nearest.point).norm() <= 1e-8 * a.nearest.distance;
  };
  std::erase_if(hits, [&, kept = std::vector<PatchHit>(hits)](PatchHit const& hit) {
    return hit.on_rim && std::ranges::any_of(kept, [&](PatchHit const& other) {
             bool const goes_first = !other.on_rim || other.patch < hit.patch;
             return other.patch != hit.patch && goes_first && same_point(hit, other);
           });
  });
}

/// Of the faces that a centre lies behind, keeps the nearest one that is not seen through the body.
void keep_nearest_way_out(SmoothSurface::Search const& search, Vec3 const& centre,
                          std::vector<SurfacePoint>& contacts, std::size_t first) {
  auto const begin = contacts.begin() + static_cast<std::ptrdiff_t>(first);
  auto const hidden = [&](SurfacePoint const& c) {
    return c.distance < 0.0 && search.is_hidden(c, centre);
  };
  auto end = std::remove_if(begin, contacts.end(), hidden);
  double shallowest = -std::numeric_limits<double>::infinity();
  for (auto c = begin; c != end; ++c)
    if (c->distance < 0.0)
      shallowest = std::max(shallowest, c->distance);
  end = std::remove_if(begin, end, [&](SurfacePoint const& c) { return c.distance < shallowest; });
  contacts.erase(end, contacts.end());
}

} // namespace

SmoothSurface::SmoothSurface(TriangleSurface surface, double smooth_angle,
                             Recognition recognition) {
  inspect_surface(surface);
  search_ = std::make_shared<Search const>(std::move(surface), smooth_angle, recognition);
}

SmoothSurface::SmoothSurface(SmoothSurface&&) noexcept = default;
SmoothSurface& SmoothSurface::operator=(SmoothSurface&&) noexcept = default;
SmoothSurface::SmoothSurface(SmoothSurface const&) = default;
SmoothSurface& SmoothSurface::operator=(SmoothSurface const&) = default;
SmoothSurface::~SmoothSurface() = default;

TriangleSurface const& SmoothSurface::triangles() const {
  return search_->surface;
}

std::span<SmoothPatch const> SmoothSurface::patches() const {
  return search_->smooth.patches;
}

void SmoothSurface::find(Vec3 const& centre, double reach, std::vector<SurfacePoint>& out) const {
  std::vector<PatchHit> hits;
  search_->patch_tree.near(centre, reach * reach, [&](std::uint32_t patch) {
    auto const hit = search_->nearest(patch, centre, reach);
    if (hit && (!hit->on_rim || search_->is_local_minimum(*hit, centre)))
      hits.push_back(*hit);
  });
  std::ranges::sort(hits, {}, &PatchHit::patch);
  if (hits.size() > 1)
    count_edges_once(hits);
  auto const first = out.size();
  bool any_behind = false;
  for (auto const& hit : hits) {
    out.push_back(hit.on_rim ? search_->rim_point(hit, centre) : search_->face_point(hit, centre));
    any_behind = any_behind || out.back().distance < 0.0;
  }
  if (any_behind)
    keep_nearest_way_out(*search_, centre, out, first);
}

SurfacePoint SmoothSurface::on_patch(std::uint32_t patch, Vec3 const& centre) const {
  EXPECT(search_->smooth.patches[patch].kind != PatchKind::curved);
  PatchHit const hit{.patch = patch,
                     .triangle = search_->smooth.triangles[patch].front(),
                     .nearest = {},
                     .on_rim = false};
  return search_->face_point(hit, centre);
}

double SmoothSurface::distance_to_rim(std::uint32_t patch, Vec3 const& point) const {
  double limit =
      std::numeric_limits<double>::infinity(); // squared distance of the nearest one so far
  search_->rim_trees[patch].near(point, limit, [&](std::uint32_t row) {
    auto const& edge = search_->edges.edges()[search_->rims[patch][row]];
    auto const& triangle = search_->curved[edge.triangles[0]];
    auto const side = edge.sides[0];
    auto const& a = triangle.corners[side];
    auto const& b = triangle.corners[(side + 1) % 3];
    double const s = closest_on_arc(a, b, triangle.bulges[side], point);
    limit = std::min(
        limit,
        (a + s * (b - a) + 4.0 * s * (1.0 - s) * triangle.bulges[side] - point).squaredNorm());
  });
  return std::sqrt(limit);
}

std::uint32_t SmoothSurface::triangle_at(std::uint32_t patch, Vec3 const& point) const {
  auto const hit = search_->nearest(patch, point, std::numeric_limits<double>::infinity());
  return hit ? hit->triangle : search_->smooth.triangles[patch].front();
}

} // namespace dem
