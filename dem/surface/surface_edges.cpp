#include "dem/surface/surface_edges.hpp"

#include "dem/expect.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <string>

namespace dem {

namespace {

/// One side of one triangle, keyed by its vertices in ascending order.
struct HalfEdge {
  std::uint32_t low, high, triangle;
  std::uint8_t side;
  bool runs_up; ///< from `low` to `high`

  bool same_edge(HalfEdge const& other) const { return low == other.low && high == other.high; }
};

std::vector<HalfEdge> sorted_half_edges(TriangleSurface const& surface) {
  std::vector<HalfEdge> halves;
  halves.reserve(3 * surface.triangles.size());
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    for (std::uint8_t side = 0; side < 3; ++side) {
      auto const from = surface.triangles[t][side];
      auto const to = surface.triangles[t][(side + 1) % 3];
      halves.push_back({std::min(from, to), std::max(from, to), t, side, from < to});
    }
  std::ranges::sort(
      halves, {}, [](HalfEdge const& h) { return std::tuple(h.low, h.high, h.triangle, h.side); });
  return halves;
}

std::string number(std::uint32_t triangle) {
  return std::to_string(std::uint64_t{triangle} + 1);
}

void refuse_bad_edge(std::string const& name, std::span<HalfEdge const> halves) {
  std::string const edge =
      "edge (" + std::to_string(halves[0].low) + ", " + std::to_string(halves[0].high) + ")";
  VALIDATE(halves.size() < 3, name + ": " + edge + " belongs to " + std::to_string(halves.size()) +
                                  " triangles, " + number(halves[0].triangle) + ", " +
                                  number(halves[1].triangle) + ", " + number(halves[2].triangle) +
                                  " (a tool surface is a manifold). Was the file exported twice?");
  VALIDATE(halves.size() < 2 || halves[0].runs_up != halves[1].runs_up,
           name + ": triangles " + number(halves[0].triangle) + " and " +
               number(halves[1].triangle) + " run the same way along their common " + edge +
               " (their normals disagree, so the outside is unknown). Repair the orientation in "
               "the CAD program?");
}

} // namespace

SurfaceEdges::SurfaceEdges(TriangleSurface const& surface)
    : of_triangle_(surface.triangles.size()), first_(surface.vertices.size() + 1, 0) {
  auto const halves = sorted_half_edges(surface);
  for (std::size_t begin = 0, end; begin < halves.size(); begin = end) {
    end = begin + 1;
    while (end < halves.size() && halves[end].same_edge(halves[begin]))
      ++end;
    refuse_bad_edge(surface.name, std::span(halves).subspan(begin, end - begin));
    auto const& one = halves[begin];
    auto const& other = halves[end - 1];
    bool const open = end - begin == 1;
    auto const row = static_cast<std::uint32_t>(edges_.size());
    edges_.push_back(
        {.vertices = one.runs_up ? std::array{one.low, one.high} : std::array{one.high, one.low},
         .triangles = {one.triangle, open ? SurfaceEdge::none : other.triangle},
         .sides = {one.side, other.side}});
    for (auto const* half : {&one, &other})
      of_triangle_[half->triangle][half->side] = row;
  }
  for (auto const& corners : surface.triangles)
    for (auto const vertex : corners)
      ++first_[vertex + 1];
  for (std::size_t v = 0; v < surface.vertices.size(); ++v)
    first_[v + 1] += first_[v];
  fans_.resize(3 * surface.triangles.size());
  auto next = first_;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    for (auto const vertex : surface.triangles[t])
      fans_[next[vertex]++] = t;
}

std::size_t SurfaceEdges::n_open() const {
  return static_cast<std::size_t>(std::ranges::count_if(edges_, &SurfaceEdge::is_open));
}

Vec3 area_vector(TriangleSurface const& surface, std::uint32_t triangle) {
  auto const& [a, b, c] = surface.triangles[triangle];
  return (surface.vertices[b] - surface.vertices[a])
      .cross(surface.vertices[c] - surface.vertices[a]);
}

} // namespace dem
