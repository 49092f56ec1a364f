#pragma once

#include "dem/surface/triangle_surface.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// Small triangle surfaces for tests.
namespace dem::solids {

/// An extrusion along y of a polygon in the (x, z) plane, closed; corners anticlockwise seen from
/// -y, convex or cut into `fan` triangles (a, b, c) of it.
inline TriangleSurface prism(std::vector<std::array<double, 2>> const& polygon, double depth,
                             std::vector<std::array<std::uint32_t, 3>> const& fan) {
  TriangleSurface solid{.name = "prism", .vertices = {}, .triangles = {}};
  auto const n = static_cast<std::uint32_t>(polygon.size());
  for (double const y : {0.0, depth})
    for (auto const& [x, z] : polygon)
      solid.vertices.emplace_back(x, y, z);
  for (std::uint32_t k = 0; k < n; ++k) {
    auto const next = (k + 1) % n;
    solid.triangles.push_back({k, k + n, next + n});
    solid.triangles.push_back({k, next + n, next});
  }
  for (auto const& [a, b, c] : fan) {
    solid.triangles.push_back({a, b, c});
    solid.triangles.push_back({a + n, c + n, b + n});
  }
  return solid;
}

/// A block [0, wx] x [0, wy] x [-h, 0]: its top face is z = 0.
inline TriangleSurface block(double wx, double wy, double h) {
  return prism({{0.0, -h}, {wx, -h}, {wx, 0.0}, {0.0, 0.0}}, wy, {{0, 1, 2}, {0, 2, 3}});
}

/// An L: a floor and a wall that meet in a concave corner along (2, y, 1), all sides 1 or 3 long.
inline TriangleSurface angle_iron(double depth) {
  return prism({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {0, 1}}, depth,
               {{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}});
}

/// The unit square z = 0 looking up, cut into about `n_triangles` by inserting random points: each
/// splits the triangle that it falls into, so the mesh is as irregular as can be. Slivers are not
/// made.
inline TriangleSurface random_square(std::size_t n_triangles, unsigned seed) {
  TriangleSurface square{.name = "square",
                         .vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                         .triangles = {{0, 1, 2}, {0, 2, 3}}};
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> weight(0.2, 0.4);
  for (std::size_t next = 0; square.triangles.size() < n_triangles; ++next) {
    auto const [a, b, c] = square.triangles[next];
    double const u = weight(generator), v = weight(generator);
    square.vertices.push_back(u * square.vertices[a] + v * square.vertices[b] +
                              (1.0 - u - v) * square.vertices[c]);
    auto const m = static_cast<std::uint32_t>(square.vertices.size() - 1);
    square.triangles[next] = {a, b, m};
    square.triangles.push_back({b, c, m});
    square.triangles.push_back({c, a, m});
  }
  return square;
}

/// A surface of revolution about z: rings of n vertices at the profile's (r, z), from bottom to
/// top, seen from outside.
inline TriangleSurface revolve(std::vector<std::array<double, 2>> const& profile, std::uint32_t n) {
  TriangleSurface surface{.name = "revolved", .vertices = {}, .triangles = {}};
  for (auto const& [r, z] : profile)
    for (std::uint32_t k = 0; k < n; ++k) {
      double const angle = 2.0 * pi * k / n;
      surface.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
  for (std::uint32_t row = 0; row + 1 < profile.size(); ++row)
    for (std::uint32_t k = 0; k < n; ++k) {
      auto const here = row * n + k, next = row * n + (k + 1) % n;
      surface.triangles.push_back({here, next, next + n});
      surface.triangles.push_back({here, next + n, here + n});
    }
  return surface;
}

} // namespace dem::solids
