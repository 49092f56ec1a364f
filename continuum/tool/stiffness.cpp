#include "continuum/tool/stiffness.hpp"

#include "continuum/tool/tool_model.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>

namespace continuum {

namespace {
using CellMatrix = Eigen::Matrix<double, 81, 81, Eigen::RowMajor>;

Eigen::Vector3d to_eigen(dealii::Tensor<1, 3> const& v) {
  return {v[0], v[1], v[2]};
}

// Blocks of 3 x 3 for every pair of nodes that share a cell, columns ascending.
SparseMatrix empty_stiffness(ToolModel const& model) {
  auto const n = static_cast<std::size_t>(model.nodes.cols());
  std::vector<std::vector<std::uint32_t>> neighbours(n);
  for (auto const& cell : model.cells)
    for (std::uint32_t const a : cell)
      neighbours[a].insert(neighbours[a].end(), cell.begin(), cell.end());
  SparseMatrix matrix(3 * n, 3 * n);
  std::size_t n_blocks = 0;
  for (auto& row : neighbours) {
    std::ranges::sort(row);
    row.erase(std::unique(row.begin(), row.end()), row.end());
    n_blocks += row.size();
  }
  matrix.resizeNonZeros(9 * n_blocks);
  int at = 0;
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t c = 0; c < 3; ++c) {
      matrix.outerIndexPtr()[3 * a + c] = at;
      for (std::uint32_t const b : neighbours[a])
        for (int d = 0; d < 3; ++d)
          matrix.innerIndexPtr()[at++] = 3 * b + d;
    }
  matrix.outerIndexPtr()[3 * n] = at;
  std::fill_n(matrix.valuePtr(), at, 0.0);
  return matrix;
}

// K_ab,ij = integral lambda N_a,i N_b,j + G N_a,j N_b,i + G delta_ij N_a,k N_b,k: all of it stands
// in M = integral g g^T, g the 81 gradient components, which one matrix product makes.
CellMatrix cell_stiffness(dealii::FEValues<3> const& values, ElasticMaterial const& material) {
  Eigen::Matrix<double, 81, 27> gradients, weighted;
  for (int q = 0; q < 27; ++q) {
    for (int a = 0; a < 27; ++a)
      gradients.block<3, 1>(3 * a, q) = to_eigen(values.shape_grad(a, q));
    weighted.col(q) = values.JxW(q) * gradients.col(q);
  }
  CellMatrix const products = weighted * gradients.transpose();
  double const lambda = material.lame_lambda(), G = material.shear_modulus();
  CellMatrix stiffness;
  for (int a = 0; a < 27; ++a)
    for (int b = 0; b < 27; ++b) {
      Eigen::Matrix3d const m = products.block<3, 3>(3 * a, 3 * b);
      stiffness.block<3, 3>(3 * a, 3 * b) =
          lambda * m + G * m.transpose() + G * m.trace() * Eigen::Matrix3d::Identity();
    }
  return stiffness;
}

void add(CellMatrix const& stiffness, std::array<std::uint32_t, 27> const& nodes,
         SparseMatrix& matrix) {
  for (int a = 0; a < 27; ++a) {
    int const row = 3 * nodes[a], begin = matrix.outerIndexPtr()[row],
              length = matrix.outerIndexPtr()[row + 1] - begin;
    int const* const columns = matrix.innerIndexPtr() + begin;
    for (int b = 0; b < 27; ++b) {
      auto const offset =
          std::lower_bound(columns, columns + length, static_cast<int>(3 * nodes[b])) - columns;
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d)
          matrix.valuePtr()[begin + c * length + offset + d] += stiffness(3 * a + c, 3 * b + d);
    }
  }
}
} // namespace

SparseMatrix assemble_stiffness(ToolModel const& model,
                                std::vector<ElasticMaterial> const& materials) {
  SparseMatrix matrix = empty_stiffness(model);
  dealii::QGauss<3> const points(3);
  dealii::FEValues<3> values(model.mapping(), model.element(), points,
                             dealii::update_gradients | dealii::update_JxW_values);
  for (auto const& cell : model.nodes_of_cells().active_cell_iterators()) {
    values.reinit(cell);
    add(cell_stiffness(values, materials[cell->material_id()]),
        model.cells[cell->active_cell_index()], matrix);
  }
  return matrix;
}

std::vector<CellStress> cell_stresses(ToolModel const& model,
                                      std::vector<ElasticMaterial> const& materials,
                                      Eigen::Matrix3Xd const& displacement, StressPlaces places) {
  dealii::Quadrature<3> const points =
      places == StressPlaces::gauss_points
          ? dealii::Quadrature<3>(dealii::QGauss<3>(3))
          : dealii::Quadrature<3>(model.element().get_unit_support_points());
  dealii::FEValues<3> values(model.mapping(), model.element(), points,
                             dealii::update_gradients | dealii::update_quadrature_points |
                                 (places == StressPlaces::gauss_points ? dealii::update_JxW_values
                                                                       : dealii::update_default));
  std::vector<CellStress> stresses;
  stresses.reserve(model.cells.size());
  for (auto const& cell : model.nodes_of_cells().active_cell_iterators()) {
    values.reinit(cell);
    std::uint32_t const number = cell->active_cell_index(), region = cell->material_id();
    stresses.push_back({.cell = number, .points = {}});
    for (unsigned q = 0; q < points.size(); ++q) {
      Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
      for (int a = 0; a < 27; ++a)
        gradient += displacement.col(model.cells[number][a]) *
                    to_eigen(values.shape_grad(a, q)).transpose();
      stresses.back().points.push_back(
          {.position = to_eigen(values.quadrature_point(q)),
           .stress = materials[region].stress(0.5 * (gradient + gradient.transpose())),
           .region = region,
           .volume = places == StressPlaces::gauss_points ? values.JxW(q) : 0.0});
    }
  }
  return stresses;
}

} // namespace continuum
