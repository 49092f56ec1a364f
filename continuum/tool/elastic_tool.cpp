#include "continuum/tool/elastic_tool.hpp"

#include "continuum/expect.hpp"
#include "continuum/hash.hpp"
#include "continuum/session.hpp"
#include "continuum/tool/factor.hpp"
#include "continuum/tool/quote.hpp"
#include "continuum/tool/rigid_motion.hpp"
#include "continuum/tool/stiffness.hpp"
#include "continuum/tool/tool_model.hpp"

#include <algorithm>

namespace continuum {

namespace {
constexpr double allowed_error = 1e-9;

std::vector<bool> held_components(ToolModel const& model, Supports const& supports) {
  std::vector<bool> held(3 * model.nodes.cols(), false);
  for (SurfaceSupport const& support : supports.surfaces) {
    std::uint32_t const surface = surface_index(model, support.surface);
    for (BoundaryFace const& face : model.boundary)
      if (face.surface == surface)
        for (std::uint32_t const node : face.nodes)
          for (int c = 0; c < 3; ++c)
            if (support.fixed[c])
              held[3 * node + c] = true;
  }
  for (NodeSupport const& support : supports.nodes) {
    VALIDATE(support.node < model.nodes.cols(),
             "a support at node " + std::to_string(support.node) + " of a tool of " +
                 std::to_string(model.nodes.cols()) +
                 " nodes (there is none). Does it come from another mesh?");
    for (int c = 0; c < 3; ++c)
      if (support.fixed[c])
        held[3 * support.node + c] = true;
  }
  if (supports.in_plane == Supports::InPlane::pinned)
    for (auto const& [node, component] : model.pins)
      held[3 * node + component] = true;
  return held;
}

void validate_materials(ToolMesh const& mesh, std::vector<ElasticMaterial> const& materials) {
  VALIDATE(materials.size() == mesh.n_regions(),
           "the tool has " + std::to_string(mesh.n_regions()) + " regions and " +
               std::to_string(materials.size()) +
               " materials (each region takes one). Does the shrink-fit ring lack its own?");
  for (std::size_t m = 0; m < materials.size(); ++m)
    materials[m].validate("material " + std::to_string(m));
}

std::uint64_t hash_of(ToolMesh const& mesh, std::vector<ElasticMaterial> const& materials,
                      std::vector<bool> const& held) {
  Fnv fnv;
  fnv.add(mesh.hash());
  for (ElasticMaterial const& material : materials)
    fnv.add(material.young_modulus).add(material.poisson_ratio);
  for (bool const is_held : held)
    fnv.add(is_held);
  return fnv.value();
}
} // namespace

struct ElasticTool::System {
  ToolMesh mesh;
  std::vector<ElasticMaterial> materials;
  std::vector<bool> held;
  std::vector<int> free; // components that move, ascending
  SparseMatrix stiffness;
  double scale; // of the reduced matrix: MUMPS sees numbers of order one, not 1e8 N/m
  SparseMatrix reduced;
  CholeskyFactor factor;
  std::uint64_t hash;

  System(ToolMesh given, std::vector<ElasticMaterial> given_materials, Supports const& supports)
      : mesh(std::move(given)), materials(std::move(given_materials)),
        held((validate_materials(mesh, materials), held_components(mesh.model(), supports))),
        free((refuse_mechanism(mesh.nodes(), held), free_components())),
        stiffness(assemble_stiffness(mesh.model(), materials)),
        scale(1.0 / stiffness.diagonal().maxCoeff()), reduced(reduce()), factor(reduced),
        hash(hash_of(mesh, materials, held)) {}

  std::vector<int> free_components() const {
    std::vector<int> components;
    for (std::size_t i = 0; i < held.size(); ++i)
      if (!held[i])
        components.push_back(i);
    return components;
  }

  SparseMatrix reduce() const {
    std::vector<int> new_number(held.size(), -1);
    for (std::size_t i = 0; i < free.size(); ++i)
      new_number[free[i]] = i;
    SparseMatrix matrix(free.size(), free.size());
    matrix.reserve(stiffness.nonZeros());
    for (std::size_t i = 0; i < free.size(); ++i) {
      matrix.startVec(i);
      for (SparseMatrix::InnerIterator entry(stiffness, free[i]); entry; ++entry)
        if (new_number[entry.col()] >= 0)
          matrix.insertBack(i, new_number[entry.col()]) = scale * entry.value();
    }
    matrix.finalize();
    return matrix;
  }

  // One step of iterative refinement: it costs a product and a back-substitution and takes the
  // residual to rounding whatever the mesh.
  Eigen::VectorXd solve_free(Eigen::VectorXd const& right_side, double& residual) const {
    double const size = right_side.norm();
    residual = 0.0;
    if (size == 0.0)
      return Eigen::VectorXd::Zero(right_side.size());
    Eigen::VectorXd u = factor.solve(right_side);
    u += factor.solve(right_side - reduced * u);
    residual = (right_side - reduced * u).norm() / size;
    return u;
  }
};

ElasticTool::ElasticTool(ToolMesh mesh, std::vector<ElasticMaterial> materials, Supports supports) {
  VALIDATE(Session::is_active(),
           "an ElasticTool without a continuum::Session (PETSc is not started). "
           "Make one at the start of main?");
  system_ = std::make_unique<System>(std::move(mesh), std::move(materials), supports);
}

ElasticTool::~ElasticTool() = default;
ElasticTool::ElasticTool(ElasticTool&&) noexcept = default;
ElasticTool& ElasticTool::operator=(ElasticTool&&) noexcept = default;

ToolMesh const& ElasticTool::mesh() const {
  return system_->mesh;
}
std::vector<ElasticMaterial> const& ElasticTool::materials() const {
  return system_->materials;
}
std::vector<bool> const& ElasticTool::is_held() const {
  return system_->held;
}
std::uint64_t ElasticTool::hash() const {
  return system_->hash;
}

Eigen::Matrix3Xd ElasticTool::spread(SurfaceTrace const& trace,
                                     Eigen::Matrix3Xd const& forces) const {
  Eigen::Matrix3Xd loads = Eigen::Matrix3Xd::Zero(3, mesh().n_nodes());
  for (std::size_t a = 0; a < trace.nodes.size(); ++a)
    loads.col(trace.nodes[a]) = forces.col(a);
  return loads;
}

ToolSolution ElasticTool::solve(Eigen::Matrix3Xd const& loads) const {
  System const& system = *system_;
  VALIDATE(loads.cols() == system.mesh.nodes().cols() && loads.allFinite(),
           "loads of " + std::to_string(loads.cols()) + " nodes on a tool of " +
               std::to_string(system.mesh.n_nodes()) +
               " nodes, or not finite (one finite force a node). Do they come from another mesh?");
  auto const n_free = static_cast<Eigen::Index>(system.free.size());
  Eigen::VectorXd right_side(n_free);
  for (Eigen::Index i = 0; i < n_free; ++i)
    right_side[i] = system.scale * loads.data()[system.free[i]];
  ToolSolution solution{.displacement = Eigen::Matrix3Xd::Zero(3, loads.cols()),
                        .reactions = Eigen::Matrix3Xd::Zero(3, loads.cols()),
                        .residual = 0.0,
                        .imbalance = 0.0,
                        .energy = 0.0};
  Eigen::VectorXd const u = system.solve_free(right_side, solution.residual);
  for (Eigen::Index i = 0; i < n_free; ++i)
    solution.displacement.data()[system.free[i]] = u[i];

  Eigen::Matrix3Xd const difference = internal_forces(solution.displacement) - loads;
  for (std::size_t i = 0; i < system.held.size(); ++i)
    if (system.held[i])
      solution.reactions.data()[i] = difference.data()[i];
  double const size = loads.colwise().norm().sum();
  if (size > 0.0)
    solution.imbalance = (loads + solution.reactions).rowwise().sum().norm() / size;
  solution.energy = 0.5 * loads.cwiseProduct(solution.displacement).sum();
  if (!(solution.residual <= allowed_error && solution.imbalance <= allowed_error))
    throw SolverFailure("elastic tool: residual " + quote(solution.residual) + ", imbalance " +
                        quote(solution.imbalance) + " (allowed " + quote(allowed_error) +
                        "). Do moduli or cell sizes differ by many orders of magnitude?");
  return solution;
}

ToolSolution ElasticTool::solve_pressure(std::string const& surface, double pressure) const {
  SurfaceTrace const trace = mesh().trace(surface);
  return solve(spread(trace, trace.pressure_loads(pressure)));
}

Eigen::Matrix3Xd ElasticTool::internal_forces(Eigen::Matrix3Xd const& displacement) const {
  Eigen::Matrix3Xd forces(3, displacement.cols());
  forces.reshaped() = system_->stiffness * displacement.reshaped();
  return forces;
}

std::vector<StressPoint> ElasticTool::stress_in_cells(Eigen::Matrix3Xd const& displacement) const {
  std::vector<StressPoint> points;
  for (auto const& cell :
       cell_stresses(mesh().model(), materials(), displacement, StressPlaces::gauss_points))
    points.insert(points.end(), cell.points.begin(), cell.points.end());
  return points;
}

std::vector<StressPoint> ElasticTool::stress_on(std::string const& surface,
                                                Eigen::Matrix3Xd const& displacement) const {
  ToolModel const& model = mesh().model();
  std::uint32_t const wanted = surface_index(model, surface);
  std::vector<std::uint32_t> const nodes = mesh().trace(surface).nodes;
  std::vector<StressPoint> points(nodes.size());
  std::vector<int> n_summed(nodes.size(), 0);
  auto const stresses = cell_stresses(model, materials(), displacement, StressPlaces::nodes);
  for (BoundaryFace const& face : model.boundary) {
    if (face.surface != wanted)
      continue;
    for (std::uint32_t const node : face.nodes) {
      auto const& cell = model.cells[face.cell];
      StressPoint const& here =
          stresses[face.cell].points[std::ranges::find(cell, node) - cell.begin()];
      std::size_t const at = std::ranges::lower_bound(nodes, node) - nodes.begin();
      Eigen::Matrix3d const sum =
          n_summed[at] ? Eigen::Matrix3d(points[at].stress + here.stress) : here.stress;
      points[at] = here;
      points[at].stress = sum;
      ++n_summed[at];
    }
  }
  for (std::size_t a = 0; a < points.size(); ++a)
    points[a].stress /= n_summed[a];
  return points;
}

std::vector<LargestStress> ElasticTool::largest_stress(Eigen::Matrix3Xd const& displacement) const {
  std::vector<StressPoint> points = stress_in_cells(displacement);
  for (std::string const& surface : mesh().surfaces()) {
    auto const more = stress_on(surface, displacement);
    points.insert(points.end(), more.begin(), more.end());
  }
  std::vector<LargestStress> largest(mesh().n_regions());
  std::vector<double> values(largest.size(), -1.0);
  for (StressPoint const& point : points)
    if (double const value = point.von_mises(); value > values[point.region]) {
      values[point.region] = value;
      largest[point.region].point = point;
    }
  for (std::size_t region = 0; region < largest.size(); ++region) {
    if (auto const& strength = materials()[region].yield_strength)
      largest[region].yield_utilisation = values[region] / *strength;
    if (auto const& strength = materials()[region].fatigue_strength)
      largest[region].fatigue_utilisation = values[region] / *strength;
  }
  return largest;
}

Eigen::MatrixXd ElasticTool::condensed_stiffness(std::vector<int> const& keep) const {
  std::vector<int> rows;
  for (int const component : keep)
    rows.push_back(std::ranges::lower_bound(system_->free, component) - system_->free.begin());
  return schur_complement(system_->reduced, rows) / system_->scale;
}

} // namespace continuum
