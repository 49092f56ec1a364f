#include "continuum/tool/body_force.hpp"

#include "continuum/tool/tool_model.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

namespace continuum {

Eigen::Matrix3Xd body_force_loads(ToolMesh const& mesh, BodyForce const& force) {
  ToolModel const& model = mesh.model();
  dealii::QGauss<3> const points(4);
  dealii::FEValues<3> values(model.mapping(), model.element(), points,
                             dealii::update_values | dealii::update_quadrature_points |
                                 dealii::update_JxW_values);
  Eigen::Matrix3Xd loads = Eigen::Matrix3Xd::Zero(3, model.nodes.cols());
  for (auto const& cell : model.nodes_of_cells().active_cell_iterators()) {
    values.reinit(cell);
    auto const& nodes = model.cells[cell->active_cell_index()];
    for (unsigned const q : values.quadrature_point_indices()) {
      auto const& x = values.quadrature_point(q);
      Eigen::Vector3d const weighted = values.JxW(q) * force({x[0], x[1], x[2]});
      for (int a = 0; a < 27; ++a)
        loads.col(nodes[a]) += values.shape_value(a, q) * weighted;
    }
  }
  return loads;
}

} // namespace continuum
