#include "continuum/tool/hex_mesh.hpp"

#include "continuum/tool/shape_checks.hpp"

#include <numbers>

namespace continuum {

namespace {
using std::numbers::pi;

std::vector<double> radii_of(DieShape const& shape, DieCells const& cells) {
  validate_length("die: bore radius", shape.bore_radius);
  validate_larger("die: outer radius", shape.outer_radius, "bore radius", shape.bore_radius);
  validate_length("die: height", shape.height);
  if (shape.ring_radius)
    validate_larger("die: ring radius", *shape.ring_radius, "outer radius", shape.outer_radius);
  validate_count("around", cells.around, 4);
  validate_count("through the wall", cells.through_wall, 1);
  validate_count("along", cells.along, 1);
  validate_growth(cells.growth);

  std::vector<double> radii =
      graded(shape.bore_radius, shape.outer_radius, cells.through_wall, cells.growth);
  if (shape.ring_radius) {
    validate_count("through the ring", cells.through_ring, 1);
    auto const ring = graded(shape.outer_radius, *shape.ring_radius, cells.through_ring, 1.0);
    radii.insert(radii.end(), ring.begin() + 1, ring.end());
  }
  return radii;
}

// Twice the place on a list of lines: odd numbers are half way between two.
double half_way(std::vector<double> const& lines, unsigned twice) {
  return 0.5 * (lines[twice / 2] + lines[(twice + 1) / 2]);
}
} // namespace

std::vector<double> graded(double from, double to, int n, double growth) {
  std::vector<double> points(n + 1, from);
  double const ratio = n > 1 ? std::pow(growth, 1.0 / (n - 1)) : 1.0;
  double size = 1.0;
  for (int i = 1; i <= n; ++i, size *= ratio)
    points[i] = points[i - 1] + size;
  double const scale = (to - from) / (points[n] - from);
  for (double& point : points)
    point = from + (point - from) * scale;
  points[n] = to; // to the bit: named radii are exact
  return points;
}

HexMesh mesh_die(DieShape const& shape, DieCells const& cells) {
  std::vector<double> const radii = radii_of(shape, cells);
  std::vector<double> const heights = graded(0.0, shape.height, cells.along, 1.0);
  unsigned const n_r = radii.size() - 1, n_t = cells.around, n_z = cells.along;
  auto const at = [&](unsigned r, unsigned t, unsigned z) {
    return (z * n_t + t % n_t) * (n_r + 1) + r;
  };
  // Counted in half cells.
  auto const position = [&](unsigned r, unsigned t, unsigned z) -> Eigen::Vector3d {
    double const radius = half_way(radii, r), angle = pi * (t % (2 * n_t)) / n_t;
    return {radius * std::cos(angle), radius * std::sin(angle), half_way(heights, z)};
  };

  HexMesh mesh{.surfaces = {"bore", "outer", "bottom", "top"}};
  for (unsigned z = 0; z <= n_z; ++z)
    for (unsigned t = 0; t < n_t; ++t)
      for (unsigned r = 0; r <= n_r; ++r)
        mesh.vertices.push_back(position(2 * r, 2 * t, 2 * z));
  for (unsigned z = 0; z < n_z; ++z)
    for (unsigned t = 0; t < n_t; ++t)
      for (unsigned r = 0; r < n_r; ++r) {
        mesh.cells.push_back({at(r, t, z), at(r + 1, t, z), at(r, t + 1, z), at(r + 1, t + 1, z),
                              at(r, t, z + 1), at(r + 1, t, z + 1), at(r, t + 1, z + 1),
                              at(r + 1, t + 1, z + 1)});
        mesh.nodes.push_back(cell_nodes([&](unsigned i, unsigned j, unsigned k) {
          return position(2 * r + i, 2 * t + j, 2 * z + k);
        }));
        mesh.regions.push_back(r < static_cast<unsigned>(cells.through_wall) ? 0 : 1);
      }
  for (unsigned t = 0; t < n_t; ++t) {
    for (unsigned z = 0; z < n_z; ++z)
      for (unsigned const end : {0u, 1u}) {
        unsigned const r = end * n_r;
        mesh.boundary.push_back(
            {{at(r, t, z), at(r, t + 1, z), at(r, t, z + 1), at(r, t + 1, z + 1)}, end});
      }
    for (unsigned r = 0; r < n_r; ++r)
      for (unsigned const end : {0u, 1u}) {
        unsigned const z = end * n_z;
        mesh.boundary.push_back(
            {{at(r, t, z), at(r + 1, t, z), at(r, t + 1, z), at(r + 1, t + 1, z)}, 2 + end});
      }
  }
  mesh.pins = {{at(n_r, 0, 0), 1}, {at(n_r, n_t / 4, 0), 0}, {at(n_r, n_t / 2, 0), 1}};
  return mesh;
}

} // namespace continuum
