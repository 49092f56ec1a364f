#include "continuum/tool/msh_file.hpp"

#include "continuum/expect.hpp"
#include "continuum/tool/gmsh_session.hpp"
#include "continuum/tool/quote.hpp"
#include "continuum/tool/raise_cell.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <span>
#include <unordered_map>

namespace continuum {

namespace {
using Tag = std::size_t;

// gmsh takes a file without this line for a script and runs it.
void validate_header(std::filesystem::path const& file) {
  std::ifstream stream(file, std::ios::binary);
  VALIDATE(stream, file.string() + ": cannot be read (no such file, or no right to). Is the path "
                                   "right?");
  std::string line;
  std::getline(stream, line);
  VALIDATE(line.starts_with("$MeshFormat"),
           file.string() + ": is no gmsh mesh (its first line is not $MeshFormat). Was it saved as "
                           ".msh, version 2.2 or 4.1?");
}

// Where each of an element's nodes stands among 3 x 3 (x 3), from its place in [-1, 1]^dim.
std::vector<unsigned> lexicographic(int type, int& n_nodes) {
  std::string name;
  int dim = 0, order = 0, n_corners = 0;
  std::vector<double> local;
  gmsh::model::mesh::getElementProperties(type, name, dim, order, n_nodes, local, n_corners);
  std::vector<unsigned> places(n_nodes, 0);
  for (int n = 0; n < n_nodes; ++n)
    for (int c = 0, stride = 1; c < dim; ++c, stride *= 3)
      places[n] += stride * static_cast<unsigned>(std::lround(local[dim * n + c] + 1.0));
  return places;
}

class Reader {
public:
  Reader(std::filesystem::path const& file, MshOptions const& options)
      : where_(file.string()), options_(options) {
    std::vector<Tag> tags;
    std::vector<double> coordinates, parametric;
    gmsh::model::mesh::getNodes(tags, coordinates, parametric, -1, -1, false, false);
    for (std::size_t n = 0; n < tags.size(); ++n)
      positions_[tags[n]] =
          options.length_unit *
          Eigen::Vector3d(coordinates[3 * n], coordinates[3 * n + 1], coordinates[3 * n + 2]);
  }

  HexMesh read() {
    gmsh::vectorpair surfaces, volumes;
    gmsh::model::getPhysicalGroups(surfaces, 2);
    gmsh::model::getPhysicalGroups(volumes, 3);
    VALIDATE(!surfaces.empty(), where_ + ": no physical surfaces (supports and loads act on named "
                                         "ones). Add Physical Surface(\"bore\") = ... ?");
    if (volumes.empty())
      read_cells(-1, 0);
    for (unsigned region = 0; region < volumes.size(); ++region)
      for (int const entity : entities_of(volumes[region]))
        read_cells(entity, region);
    for (auto const& group : surfaces)
      read_surface(group);
    for (std::string const& name : options_.required_surfaces)
      VALIDATE(std::ranges::count(mesh_.surfaces, name) == 1,
               where_ + ": no physical surface '" + name + "' (it has " + known_surfaces() +
                   "; the case asks for it). Is it misspelt?");
    return std::move(mesh_);
  }

private:
  static std::vector<int> entities_of(std::pair<int, int> const& group) {
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(group.first, group.second, entities);
    return entities;
  }

  std::string known_surfaces() const {
    std::string known;
    for (std::string const& name : mesh_.surfaces)
      known += (known.empty() ? "" : ", ") + name;
    return known;
  }

  unsigned vertex(Tag tag) {
    auto const [found, is_new] = vertices_.try_emplace(tag, mesh_.vertices.size());
    if (is_new)
      mesh_.vertices.push_back(positions_.at(tag));
    return found->second;
  }

  // Visits the nodes of each element of the entity, `places` saying where they stand.
  template <class Visit> void for_each_element(int dim, int entity, int n_corners, Visit visit) {
    std::vector<int> types;
    std::vector<std::vector<Tag>> tags, nodes;
    gmsh::model::mesh::getElements(types, tags, nodes, dim, entity);
    for (std::size_t t = 0; t < types.size(); ++t) {
      int n_nodes = 0;
      std::string name;
      int of_dim = 0, order = 0, corners = 0;
      std::vector<double> local;
      gmsh::model::mesh::getElementProperties(types[t], name, of_dim, order, n_nodes, local,
                                              corners);
      VALIDATE(corners == n_corners && order <= 2,
               where_ + ": elements of the kind '" + name +
                   "' (the solver has hexahedra with quadrilateral faces, of first or second "
                   "order). Recombine the mesh, or lower its order?");
      auto const places = lexicographic(types[t], n_nodes);
      for (std::size_t e = 0; e < tags[t].size(); ++e)
        visit(std::span(nodes[t]).subspan(e * n_nodes, n_nodes), places);
    }
  }

  void read_cells(int entity, unsigned region) {
    for_each_element(3, entity, 8, [&](auto const& tags, auto const& places) {
      HexMesh::CellNodes nodes;
      nodes.fill(Eigen::Vector3d::Zero());
      std::array<bool, 27> is_known{};
      std::array<unsigned, 8> cell{};
      for (std::size_t n = 0; n < tags.size(); ++n) {
        unsigned const i = places[n] % 3, j = places[n] / 3 % 3, k = places[n] / 9;
        nodes[places[n]] = positions_.at(tags[n]);
        is_known[places[n]] = true;
        if (i != 1 && j != 1 && k != 1)
          cell[4 * (k / 2) + 2 * (j / 2) + i / 2] = vertex(tags[n]);
      }
      raise_cell(nodes, is_known);
      mesh_.cells.push_back(cell);
      mesh_.nodes.push_back(nodes);
      mesh_.regions.push_back(region);
    });
  }

  void read_surface(std::pair<int, int> const& group) {
    std::string name;
    gmsh::model::getPhysicalName(group.first, group.second, name);
    mesh_.surfaces.push_back(name.empty() ? "surface " + std::to_string(group.second) : name);
    unsigned const surface = mesh_.surfaces.size() - 1;
    for (int const entity : entities_of(group))
      for_each_element(2, entity, 4, [&](auto const& tags, auto const& places) {
        std::array<unsigned, 4> quad{};
        for (std::size_t n = 0; n < tags.size(); ++n) {
          unsigned const i = places[n] % 3, j = places[n] / 3;
          if (i != 1 && j != 1)
            quad[2 * (j / 2) + i / 2] = vertex(tags[n]);
        }
        mesh_.boundary.push_back({quad, surface});
      });
  }

  std::string where_;
  MshOptions const& options_;
  std::unordered_map<Tag, Eigen::Vector3d> positions_;
  std::unordered_map<Tag, unsigned> vertices_;
  HexMesh mesh_;
};
} // namespace

HexMesh read_msh(std::filesystem::path const& file, MshOptions const& options) {
  VALIDATE(std::isfinite(options.length_unit) && options.length_unit > 0.0,
           file.string() + ": length unit = " + quote(options.length_unit) +
               " m (a unit is positive). 0.001 for mm?");
  validate_header(file);
  HexMesh mesh;
  with_gmsh(file, [&] {
    gmsh::open(file.string());
    mesh = Reader(file, options).read();
  });
  return mesh;
}

} // namespace continuum
