#include "dem/surface/weld.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>

namespace dem {

namespace {

/// Vertices by the cell of a grid as wide as the welding distance.
class VertexGrid {
public:
  VertexGrid(std::vector<Vec3>& vertices, Vec3 const& origin, double distance)
      : vertices_(vertices), origin_(origin), distance_(distance) {}

  std::uint32_t find_or_add(Vec3 const& corner) {
    Cell const home = cell_of(corner);
    if (auto const found = find(corner, home))
      return *found;
    auto const row = static_cast<std::uint32_t>(vertices_.size());
    vertices_.push_back(corner);
    cells_.emplace(home, row);
    return row;
  }

private:
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(Cell const& cell) const {
      std::uint64_t h = 0;
      for (auto const k : cell)
        h = ((h ^ (h >> 29)) + static_cast<std::uint64_t>(k)) * 0x9e3779b97f4a7c15u;
      return h;
    }
  };

  std::optional<std::uint32_t> find(Vec3 const& corner, Cell const& home) const {
    std::optional<std::uint32_t> first;
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        for (std::int64_t dz = -1; dz <= 1; ++dz) {
          auto [begin, end] = cells_.equal_range({home[0] + dx, home[1] + dy, home[2] + dz});
          for (; begin != end; ++begin) {
            auto const row = begin->second;
            if ((vertices_[row] - corner).norm() <= distance_ && (!first || row < *first))
              first = row;
          }
        }
    return first;
  }

  /// From the box's corner: coordinates in units of the distance then fit into an integer, wherever
  /// the tool is.
  Cell cell_of(Vec3 const& corner) const {
    Vec3 const cell = (corner - origin_) / distance_;
    auto const row = [&](int k) { return static_cast<std::int64_t>(std::floor(cell[k])); };
    return {row(0), row(1), row(2)};
  }

  std::vector<Vec3>& vertices_;
  Vec3 origin_;
  double distance_;
  std::unordered_multimap<Cell, std::uint32_t, Hash> cells_;
};

} // namespace

TriangleSurface weld(std::string name, std::span<std::array<Vec3, 3> const> facets, Box const& box,
                     double distance) {
  TriangleSurface surface{.name = std::move(name), .vertices = {}, .triangles = {}};
  VertexGrid grid(surface.vertices, box.low, distance);
  surface.triangles.reserve(facets.size());
  for (auto const& corners : facets)
    surface.triangles.push_back(
        {grid.find_or_add(corners[0]), grid.find_or_add(corners[1]), grid.find_or_add(corners[2])});
  return surface;
}

} // namespace dem
