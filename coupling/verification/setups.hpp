#pragma once

#include "dem/step/advance.hpp"
#include "dem/step/world.hpp"

#include <string>
#include <utility>

/// Small worlds whose answer is known: one or two grains, a plate. Header only, so that tests of
/// dem/ can use them.
namespace coupling::verification {

/// A closed rectangular plate whose upper face z = 0 is n x n squares of two triangles each; the
/// diagonals alternate in direction when `crossed`. Only the triangulation of the upper face
/// depends on n.
inline dem::TriangleSurface plate(double half_width, double thickness, int n = 1,
                                  bool crossed = false) {
  dem::TriangleSurface surface{.name = "plate", .vertices = {}, .triangles = {}};
  auto const at = [n](int i, int j) { return static_cast<std::uint32_t>(i * (n + 1) + j); };
  double const cell = 2.0 * half_width / n;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      surface.vertices.emplace_back(-half_width + i * cell, -half_width + j * cell, 0.0);
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      std::uint32_t const a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      bool const other = crossed && (i + j) % 2 == 1;
      surface.triangles.push_back(other ? std::array{a, b, d} : std::array{a, b, c});
      surface.triangles.push_back(other ? std::array{b, c, d} : std::array{a, c, d});
    }
  }
  // Skirts run through every rim vertex of the upper face so that the surface stays closed; one fan
  // is the bottom.
  std::vector<std::uint32_t> rim;
  for (int i = 0; i < n; ++i)
    rim.push_back(at(i, 0));
  for (int j = 0; j < n; ++j)
    rim.push_back(at(n, j));
  for (int i = n; i > 0; --i)
    rim.push_back(at(i, n));
  for (int j = n; j > 0; --j)
    rim.push_back(at(0, j));
  auto const below = static_cast<std::uint32_t>(surface.vertices.size());
  for (std::uint32_t k : rim) {
    surface.vertices.push_back(surface.vertices[k] - dem::Vec3(0.0, 0.0, thickness));
  }
  auto const centre = static_cast<std::uint32_t>(surface.vertices.size());
  surface.vertices.emplace_back(0.0, 0.0, -thickness);
  auto const m = static_cast<std::uint32_t>(rim.size());
  for (std::uint32_t k = 0; k < m; ++k) {
    std::uint32_t const next = (k + 1) % m;
    surface.triangles.push_back({rim[k], below + k, rim[next]});
    surface.triangles.push_back({rim[next], below + k, below + next});
    surface.triangles.push_back({below + k, centre, below + next});
  }
  return surface;
}

/// The same surface turned by a rotation.
inline dem::TriangleSurface turned(dem::TriangleSurface surface, Eigen::Matrix3d const& rotation) {
  for (dem::Vec3& vertex : surface.vertices)
    vertex = rotation * vertex;
  return surface;
}

/// A plate whose face z = 0 looks down.
inline dem::TriangleSurface ceiling(double half_width, double thickness) {
  return turned(plate(half_width, thickness), Eigen::Vector3d(1, -1, -1).asDiagonal());
}

/// What a small world is made of: material 0 is the grains', material 1 the tools'.
struct Recipe {
  dem::Material grain{"grain", 3500.0, 250e6, 0.25};
  dem::Material wall{"wall", 8000.0, 200e6, 0.29};
  dem::Interaction grain_grain{};
  dem::Interaction grain_wall{};
  dem::ContactChoice law{};
  dem::Vec3 gravity = dem::Vec3::Zero();
};

/// Hertz without cohesion or friction.
inline Recipe smooth(double restitution = 1.0, dem::Precision precision = dem::Precision::full) {
  Recipe recipe;
  recipe.law.cohesion = "none";
  recipe.law.tangential = "frictionless";
  recipe.law.precision = precision;
  recipe.grain_grain.restitution = restitution;
  recipe.grain_wall.restitution = restitution;
  return recipe;
}

inline dem::World empty_world(Recipe const& recipe) {
  dem::World world;
  world.materials.add(recipe.grain);
  world.materials.add(recipe.wall);
  world.materials.set_interaction(0, 0, recipe.grain_grain);
  world.materials.set_interaction(0, 1, recipe.grain_wall);
  world.materials.set_interaction(1, 1, recipe.grain_wall);
  world.gravity = recipe.gravity;
  world.contacts = dem::ContactEngine(recipe.law);
  return world;
}

/// Adds a tool of material 1 and returns its index.
inline std::size_t add_tool(dem::World& world, std::string name, dem::TriangleSurface surface,
                            dem::Vec3 const& displacement = dem::Vec3::Zero(),
                            dem::Vec3 const& velocity = dem::Vec3::Zero()) {
  world.tools.push_back(dem::Tool{.name = std::move(name),
                                  .surface = dem::SmoothSurface(std::move(surface)),
                                  .material = 1,
                                  .displacement = displacement,
                                  .velocity = velocity});
  return world.tools.size() - 1;
}

/// Row of the grain with this id; rows change when grains are sorted.
inline std::size_t row_of(dem::World const& world, std::uint32_t id) {
  for (std::size_t row = 0; row < world.grains.size(); ++row) {
    if (world.grains.id[row] == id)
      return row;
  }
  return world.grains.size();
}

} // namespace coupling::verification
