#include "continuum/tool/stl_file.hpp"

#include "continuum/expect.hpp"
#include "continuum/tool/curved_skin.hpp"
#include "continuum/tool/gmsh_session.hpp"
#include "continuum/tool/quote.hpp"
#include "continuum/tool/tet_subdivision.hpp"
#include "continuum/tool/triangle_distance.hpp"

#include <Eigen/Geometry>
#include <gmsh.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

namespace continuum {

namespace {
using Tag = std::size_t;
constexpr int triangle = 2, tetrahedron = 4; // gmsh's kinds of elements

void validate(StlOptions const& options, std::string const& where) {
  auto const positive = [&](double value, char const* what) {
    VALIDATE(std::isfinite(value) && value > 0.0, where + ": " + what + " = " + quote(value) +
                                                      " m (a length is positive). Is it misspelt?");
  };
  positive(options.cell_size, "cell size");
  positive(options.gap_tolerance, "gap tolerance");
  positive(options.length_unit, "length unit");
  positive(options.shape_tolerance, "shape tolerance");
  VALIDATE(options.feature_angle > 0.0 && options.feature_angle < std::numbers::pi,
           where + ": feature angle = " + quote(options.feature_angle) +
               " rad (between 0 and pi; flat facets meet at 0). Was it given in degrees?");
}

double distance_from(PlaneShape const& plane, Eigen::Vector3d const& x) {
  return std::abs((x - plane.point).dot(plane.normal.normalized()));
}
double distance_from(CylinderShape const& cylinder, Eigen::Vector3d const& x) {
  return std::abs((x - cylinder.point).cross(cylinder.axis.normalized()).norm() - cylinder.radius);
}

// The nodes that gmsh has at a moment, [m], counted from zero.
struct Nodes {
  std::vector<Eigen::Vector3d> positions;
  std::unordered_map<Tag, unsigned> numbers;

  explicit Nodes(double length_unit) {
    std::vector<Tag> tags;
    std::vector<double> x, parametric;
    gmsh::model::mesh::getNodes(tags, x, parametric, -1, -1, false, false);
    for (std::size_t n = 0; n < tags.size(); ++n) {
      numbers[tags[n]] = n;
      positions.push_back(length_unit * Eigen::Vector3d(x[3 * n], x[3 * n + 1], x[3 * n + 2]));
    }
  }

  template <std::size_t n>
  std::vector<std::array<unsigned, n>> elements(int kind, int entity) const {
    std::vector<Tag> tags, nodes;
    gmsh::model::mesh::getElementsByType(kind, tags, nodes, entity);
    std::vector<std::array<unsigned, n>> corners(tags.size());
    for (std::size_t e = 0; e < nodes.size(); ++e)
      corners[e / n][e % n] = numbers.at(nodes[e]);
    return corners;
  }
  Triangles triangles() const { return {positions, elements<3>(triangle, -1)}; }
};

void refuse_open(Triangles const& skin, std::string const& where) {
  VALIDATE(!skin.corners.empty(),
           where + ": no triangles (a body needs a skin). Is the file empty, or damaged?");
  std::map<std::pair<unsigned, unsigned>, int> n_sides;
  for (auto const& t : skin.corners)
    for (int e = 0; e < 3; ++e)
      ++n_sides[std::minmax(t[e], t[(e + 1) % 3])];
  for (auto const& [edge, n] : n_sides)
    VALIDATE(n == 2, where + ": the edge at " + quote_position(skin.vertices[edge.first]) +
                         " belongs to " + std::to_string(n) +
                         (n == 1 ? " triangle" : " triangles") +
                         " (a closed skin has two at an edge). Is there a hole, or a part twice?");
}

class Namer {
public:
  Namer(StlOptions const& options, std::string const& where) : options_(options), where_(where) {}

  /// Number of the surface that a patch with these vertices is part of.
  unsigned operator()(std::vector<Eigen::Vector3d> const& vertices) {
    std::string closest;
    double least = std::numeric_limits<double>::infinity();
    for (NamedShape const& surface : options_.surfaces) {
      double off = 0.0;
      for (Eigen::Vector3d const& x : vertices)
        off = std::max(off, std::visit([&](auto const& shape) { return distance_from(shape, x); },
                                       surface.shape));
      if (off <= options_.shape_tolerance)
        return number(surface.name);
      if (off < least) {
        least = off;
        closest = surface.name;
      }
    }
    VALIDATE(options_.other_surface,
             where_ + ": the patch at " + quote_position(vertices.at(0)) +
                 " lies on no named shape (supports and loads act on named surfaces)" +
                 (closest.empty() ? std::string(".")
                                  : "; '" + closest + "' is " + quote(least) +
                                        " m off, with a shape tolerance of " +
                                        quote(options_.shape_tolerance) + " m.") +
                 " Name it, or give a name for the others?");
    return number(*options_.other_surface);
  }

  /// Names found so far.
  std::vector<std::string> const& names() const { return names_; }

  /// Of each name: its cylinder, if it has that one shape only.
  std::vector<std::optional<CylinderShape>> cylinders() const {
    std::vector<std::optional<CylinderShape>> found;
    for (std::string const& name : names_) {
      bool const is_one = std::ranges::count(options_.surfaces, name, &NamedShape::name) == 1 &&
                          name != options_.other_surface;
      auto const named = std::ranges::find(options_.surfaces, name, &NamedShape::name);
      auto const* cylinder = is_one ? std::get_if<CylinderShape>(&named->shape) : nullptr;
      found.push_back(cylinder ? std::optional(*cylinder) : std::nullopt);
    }
    return found;
  }

private:
  unsigned number(std::string const& name) {
    auto const found = std::ranges::find(names_, name);
    if (found == names_.end()) {
      names_.push_back(name);
      return names_.size() - 1;
    }
    return found - names_.begin();
  }

  StlOptions const& options_;
  std::string const& where_;
  std::vector<std::string> names_;
};

std::vector<int> patches() {
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, 2);
  std::vector<int> tags;
  for (auto const& entity : entities)
    tags.push_back(entity.second);
  return tags;
}

// Parts the skin into patches along its sharp edges and names them, before they are meshed anew.
std::map<int, unsigned> name_patches(StlOptions const& options, Namer& name) {
  gmsh::model::mesh::classifySurfaces(options.feature_angle, true, true);
  Nodes const nodes(options.length_unit);
  std::map<int, unsigned> surface_of;
  for (int const patch : patches()) {
    std::vector<Eigen::Vector3d> vertices;
    for (auto const& corners : nodes.elements<3>(triangle, patch))
      for (unsigned const corner : corners)
        vertices.push_back(nodes.positions[corner]);
    surface_of[patch] = name(vertices);
  }
  return surface_of;
}

void mesh_inside(double size) {
  gmsh::model::mesh::createGeometry();
  gmsh::model::geo::addVolume({gmsh::model::geo::addSurfaceLoop(patches())});
  gmsh::model::geo::synchronize();
  gmsh::option::setNumber("Mesh.MeshSizeMin", size);
  gmsh::option::setNumber("Mesh.MeshSizeMax", size);
  gmsh::model::mesh::generate(3);
}

struct TetMesh {
  std::vector<std::array<unsigned, 4>> tetrahedra;
  std::map<std::array<unsigned, 3>, unsigned> skin; // surface of a triangle, its corners ascending
};

TetMesh tetrahedra_of(Nodes const& nodes, std::map<int, unsigned> const& surface_of) {
  TetMesh mesh{.tetrahedra = nodes.elements<4>(tetrahedron, -1), .skin = {}};
  for (auto const& [patch, surface] : surface_of)
    for (auto corners : nodes.elements<3>(triangle, patch)) {
      std::ranges::sort(corners);
      mesh.skin[corners] = surface;
    }
  return mesh;
}

std::array<std::array<unsigned, 3>, 4> faces_of(std::array<unsigned, 4> corners) {
  std::ranges::sort(corners);
  auto const& [a, b, c, d] = corners;
  return {{{a, b, c}, {a, b, d}, {a, c, d}, {b, c, d}}};
}

// A tetrahedron with two faces on one round surface lies between two ways of parting it into
// triangles, and has no body once it is round: it goes, and its other faces are the surface.
void drop_flat_ones(TetMesh& mesh, std::vector<std::optional<CylinderShape>> const& cylinders) {
  std::erase_if(mesh.tetrahedra, [&](std::array<unsigned, 4> const& corners) {
    std::vector<std::array<unsigned, 3>> outside, inside;
    for (auto const& face : faces_of(corners))
      (mesh.skin.contains(face) ? outside : inside).push_back(face);
    if (outside.size() != 2)
      return false;
    unsigned const surface = mesh.skin.at(outside[0]);
    if (!cylinders[surface] || mesh.skin.at(outside[1]) != surface)
      return false;
    for (auto const& face : outside)
      mesh.skin.erase(face);
    for (auto const& face : inside)
      mesh.skin[face] = surface;
    return true;
  });
}

HexMesh cut(Nodes const& nodes, TetMesh const& mesh, std::vector<std::string> const& names) {
  TetSubdivision cut(nodes.positions);
  for (auto const& corners : mesh.tetrahedra)
    cut.add_tetrahedron(corners);
  for (auto const& [corners, surface] : mesh.skin)
    cut.add_triangle(corners, surface);
  return cut.take(names);
}

StlBody mesh_body(std::filesystem::path const& file, StlOptions const& options) {
  std::string const where = file.string();
  gmsh::merge(where);
  Triangles const skin = Nodes(options.length_unit).triangles();
  refuse_open(skin, where);
  Namer name(options, where);
  auto const surface_of = name_patches(options, name);
  mesh_inside(options.cell_size / options.length_unit);

  Nodes const nodes(options.length_unit);
  TetMesh tetrahedra = tetrahedra_of(nodes, surface_of);
  drop_flat_ones(tetrahedra, name.cylinders());
  HexMesh mesh = cut(nodes, tetrahedra, name.names());
  curve_onto(mesh, name.cylinders());
  double const gap = largest_gap(skin, skin_of(mesh));
  VALIDATE(gap <= options.gap_tolerance,
           where + ": the mesh leaves the STL by " + quote(gap) + " m (allowed " +
               quote(options.gap_tolerance) +
               " m; grains would touch another shape than the one that yields). Make the cell size "
               "of " +
               quote(options.cell_size) + " m smaller, or the STL's own facets?");
  return {std::move(mesh), gap};
}
} // namespace

StlBody mesh_stl(std::filesystem::path const& file, StlOptions const& options) {
  validate(options, file.string());
  VALIDATE(std::filesystem::exists(file),
           file.string() + ": cannot be read (no such file). Is the path right?");
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return std::tolower(c); });
  // gmsh takes a file of another ending for a script and runs it.
  VALIDATE(extension == ".stl", file.string() + ": is no STL by its name (the ending is '" +
                                    extension + "'). Rename it to .stl?");
  StlBody body;
  with_gmsh(file, [&] { body = mesh_body(file, options); });
  return body;
}

} // namespace continuum
