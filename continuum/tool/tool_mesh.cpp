#include "continuum/tool/tool_mesh.hpp"

#include "continuum/expect.hpp"
#include "continuum/hash.hpp"
#include "continuum/tool/hex_mesh_checks.hpp"
#include "continuum/tool/msh_file.hpp"
#include "continuum/tool/quote.hpp"
#include "continuum/tool/stl_file.hpp"
#include "continuum/tool/tool_model.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/tria.h>

#include <algorithm>

namespace continuum {

namespace {
void triangulate(HexMesh const& mesh, dealii::Triangulation<3>& triangulation) {
  std::vector<dealii::Point<3>> vertices;
  for (auto const& v : mesh.vertices)
    vertices.emplace_back(v.x(), v.y(), v.z());
  std::vector<dealii::CellData<3>> cells(mesh.cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    cells[c].vertices.assign(mesh.cells[c].begin(), mesh.cells[c].end());
    cells[c].material_id = mesh.regions[c];
  }
  dealii::SubCellData boundary;
  for (HexMesh::Quad const& quad : mesh.boundary) {
    boundary.boundary_quads.emplace_back();
    boundary.boundary_quads.back().vertices.assign(quad.vertices.begin(), quad.vertices.end());
    boundary.boundary_quads.back().boundary_id = quad.surface;
  }
  triangulation.create_triangulation(vertices, cells, boundary);
}

// The library asks for the nodes of a cell in the element's own order: corners, edges, faces, cell.
void place_nodes(HexMesh const& mesh, dealii::Triangulation<3> const& triangulation,
                 dealii::FE_Q<3> const& element, dealii::MappingQCache<3>& mapping) {
  std::vector<unsigned> const to_lexicographic = element.get_poly_space_numbering();
  mapping.initialize(triangulation, [&](dealii::Triangulation<3>::cell_iterator const& cell) {
    std::vector<dealii::Point<3>> points;
    for (unsigned const i : to_lexicographic) {
      Eigen::Vector3d const& x = mesh.nodes[cell->index()][i];
      points.emplace_back(x.x(), x.y(), x.z());
    }
    return points;
  });
}

void refuse_inverted_cells(ToolModel const& model, std::string const& where) {
  dealii::QGauss<3> const points(3);
  dealii::FEValues<3> values(model.mapping(), model.element(), points, dealii::update_jacobians);
  for (auto const& cell : model.nodes_of_cells().active_cell_iterators()) {
    values.reinit(cell);
    for (unsigned const q : values.quadrature_point_indices())
      VALIDATE(values.jacobian(q).determinant() > 0.0,
               where + ": cell " + std::to_string(cell->active_cell_index()) + " at (" +
                   quote(cell->center()[0]) + ", " + quote(cell->center()[1]) + ", " +
                   quote(cell->center()[2]) +
                   ") m is inverted (its volume is not positive). Use more cells, or less growth?");
  }
}

// The two reference directions that follow `direction` cyclically make a right-handed face; at the
// low end the body is on the other side, so they change places.
std::array<std::uint32_t, 9> face_nodes(std::array<std::uint32_t, 27> const& lexicographic,
                                        unsigned face) {
  unsigned const direction = face / 2, end = face % 2;
  std::array<unsigned, 3> const stride = {1, 3, 9};
  unsigned along_xi = stride[(direction + 1) % 3], along_eta = stride[(direction + 2) % 3];
  if (end == 0)
    std::swap(along_xi, along_eta);
  std::array<std::uint32_t, 9> nodes;
  for (unsigned j = 0; j < 3; ++j)
    for (unsigned i = 0; i < 3; ++i)
      nodes[3 * j + i] = lexicographic[2 * end * stride[direction] + i * along_xi + j * along_eta];
  return nodes;
}

void collect_cells(HexMesh const& mesh, ToolModel& model) {
  std::vector<unsigned> const to_lexicographic = model.element().get_poly_space_numbering();
  std::vector<dealii::types::global_dof_index> dofs(27);
  std::vector<std::uint32_t> node_of_vertex(mesh.vertices.size());
  for (auto const& cell : model.nodes_of_cells().active_cell_iterators()) {
    cell->get_dof_indices(dofs);
    std::array<std::uint32_t, 27> own, lexicographic;
    for (unsigned i = 0; i < 27; ++i) {
      own[i] = dofs[i];
      lexicographic[to_lexicographic[i]] = dofs[i];
    }
    for (unsigned const v : cell->vertex_indices())
      node_of_vertex[cell->vertex_index(v)] = cell->vertex_dof_index(v, 0);
    for (unsigned const f : cell->face_indices())
      if (cell->face(f)->at_boundary())
        model.boundary.push_back({face_nodes(lexicographic, f), cell->face(f)->boundary_id(),
                                  static_cast<std::uint32_t>(model.cells.size())});
    model.cells.push_back(own);
    model.regions.push_back(cell->material_id());
    model.n_regions = std::max(model.n_regions, model.regions.back() + 1);
  }
  for (Pin const& pin : mesh.pins)
    model.pins.emplace_back(node_of_vertex[pin.vertex], pin.component);
}

// Cells that share a node must have it at the same place.
void refuse_gaps(ToolModel const& model, HexMesh const& mesh, std::string const& where) {
  std::vector<unsigned> const to_lexicographic = model.element().get_poly_space_numbering();
  double const size = (model.nodes.rowwise().maxCoeff() - model.nodes.rowwise().minCoeff()).norm();
  for (std::size_t c = 0; c < model.cells.size(); ++c)
    for (unsigned i = 0; i < 27; ++i) {
      Eigen::Vector3d const here = mesh.nodes[c][to_lexicographic[i]],
                            there = model.nodes.col(model.cells[c][i]);
      VALIDATE((here - there).norm() <= 1e-9 * size,
               where + ": cell " + std::to_string(c) + " has a node at " + quote_position(here) +
                   " where its neighbour has " + quote_position(there) +
                   " (a gap would open between them). Are nodes of the common face mixed up?");
    }
}

std::uint64_t hash_of(ToolModel const& model) {
  Fnv fnv;
  fnv.add_bytes(std::as_bytes(std::span(model.nodes.data(), model.nodes.size())));
  for (auto const& cell : model.cells)
    fnv.add_bytes(std::as_bytes(std::span(cell)));
  fnv.add_bytes(std::as_bytes(std::span(model.regions)));
  for (BoundaryFace const& face : model.boundary)
    fnv.add_bytes(std::as_bytes(std::span(face.nodes))).add(face.surface);
  for (std::string const& name : model.surfaces)
    fnv.add(name);
  return fnv.value();
}

SurfaceTrace trace_of(ToolModel const& model, std::vector<std::uint32_t> const& wanted) {
  SurfaceTrace trace;
  std::vector<std::uint32_t> renumbered(model.surfaces.size(), ~0u);
  for (std::uint32_t const surface : wanted) {
    renumbered[surface] = trace.surfaces.size();
    trace.surfaces.push_back(model.surfaces[surface]);
  }
  for (BoundaryFace const& face : model.boundary)
    if (renumbered[face.surface] != ~0u) {
      trace.faces.push_back({face.nodes, renumbered[face.surface]});
      trace.nodes.insert(trace.nodes.end(), face.nodes.begin(), face.nodes.end());
    }
  std::ranges::sort(trace.nodes);
  trace.nodes.erase(std::unique(trace.nodes.begin(), trace.nodes.end()), trace.nodes.end());
  for (TraceFace& face : trace.faces)
    for (std::uint32_t& node : face.nodes)
      node = std::ranges::lower_bound(trace.nodes, node) - trace.nodes.begin();
  trace.positions.resize(3, trace.nodes.size());
  for (std::size_t a = 0; a < trace.nodes.size(); ++a)
    trace.positions.col(a) = model.nodes.col(trace.nodes[a]);
  return trace;
}
} // namespace

struct ToolModel::Discretisation {
  explicit Discretisation(HexMesh const& mesh) {
    triangulate(mesh, triangulation);
    place_nodes(mesh, triangulation, element, mapping);
    nodes_of_cells.reinit(triangulation);
    nodes_of_cells.distribute_dofs(element);
  }

  dealii::Triangulation<3> triangulation;
  dealii::FE_Q<3> element{2};
  dealii::MappingQCache<3> mapping{2};
  dealii::DoFHandler<3> nodes_of_cells;
};

ToolModel::ToolModel(HexMesh const& mesh, std::string const& where)
    : surfaces(mesh.surfaces), discretisation_(std::make_unique<Discretisation const>(mesh)) {
  refuse_inverted_cells(*this, where);
  std::vector<dealii::Point<3>> points(nodes_of_cells().n_dofs());
  dealii::DoFTools::map_dofs_to_support_points(mapping(), nodes_of_cells(), points);
  nodes.resize(3, points.size());
  for (std::size_t a = 0; a < points.size(); ++a)
    nodes.col(a) << points[a][0], points[a][1], points[a][2];
  collect_cells(mesh, *this);
  hash = hash_of(*this);
}

ToolModel::~ToolModel() = default;

dealii::Triangulation<3, 3> const& ToolModel::triangulation() const {
  return discretisation_->triangulation;
}
dealii::MappingQ<3, 3> const& ToolModel::mapping() const {
  return discretisation_->mapping;
}
dealii::FE_Q<3, 3> const& ToolModel::element() const {
  return discretisation_->element;
}
dealii::DoFHandler<3, 3> const& ToolModel::nodes_of_cells() const {
  return discretisation_->nodes_of_cells;
}

std::uint32_t surface_index(ToolModel const& model, std::string const& name) {
  auto const found = std::ranges::find(model.surfaces, name);
  if (found != model.surfaces.end())
    return found - model.surfaces.begin();
  std::string known;
  for (std::string const& surface : model.surfaces)
    known += (known.empty() ? "" : ", ") + surface;
  throw InvalidInput("surface '" + name + "' is not part of the tool (it has " + known +
                     "). Is it misspelt?");
}

ToolMesh::ToolMesh(std::shared_ptr<ToolModel const> model) : model_(std::move(model)) {}

ToolMesh ToolMesh::die(DieShape const& shape, DieCells const& cells) {
  return ToolMesh(std::make_shared<ToolModel const>(mesh_die(shape, cells)));
}
ToolMesh ToolMesh::punch(PunchShape const& shape, PunchCells const& cells) {
  return ToolMesh(std::make_shared<ToolModel const>(mesh_punch(shape, cells)));
}
ToolMesh ToolMesh::from_hexes(HexMesh const& mesh, std::string const& where) {
  validate(mesh, where);
  auto const model = std::make_shared<ToolModel const>(mesh, where);
  refuse_gaps(*model, mesh, where);
  return ToolMesh(model);
}
ToolMesh ToolMesh::from_msh(std::filesystem::path const& file, MshOptions const& options) {
  return from_hexes(read_msh(file, options), file.string());
}
StlTool ToolMesh::from_stl(std::filesystem::path const& file, StlOptions const& options) {
  StlBody const body = mesh_stl(file, options);
  return {from_hexes(body.mesh, file.string()), body.largest_gap};
}

std::vector<std::string> const& ToolMesh::surfaces() const {
  return model_->surfaces;
}
std::size_t ToolMesh::n_cells() const {
  return model_->cells.size();
}
std::size_t ToolMesh::n_nodes() const {
  return model_->nodes.cols();
}
std::size_t ToolMesh::n_regions() const {
  return model_->n_regions;
}
Eigen::Matrix3Xd const& ToolMesh::nodes() const {
  return model_->nodes;
}
std::array<std::uint32_t, 27> ToolMesh::cell_nodes(std::size_t cell) const {
  std::vector<unsigned> const to_lexicographic = model_->element().get_poly_space_numbering();
  std::array<std::uint32_t, 27> nodes;
  for (unsigned i = 0; i < 27; ++i)
    nodes[to_lexicographic[i]] = model_->cells.at(cell)[i];
  return nodes;
}
std::uint32_t ToolMesh::region(std::size_t cell) const {
  return model_->regions.at(cell);
}
std::uint64_t ToolMesh::hash() const {
  return model_->hash;
}

SurfaceTrace ToolMesh::trace(std::string const& surface) const {
  return trace_of(*model_, {surface_index(*model_, surface)});
}

SurfaceTrace ToolMesh::boundary() const {
  std::vector<std::uint32_t> all(model_->surfaces.size());
  for (std::uint32_t surface = 0; surface < all.size(); ++surface)
    all[surface] = surface;
  return trace_of(*model_, all);
}

} // namespace continuum
