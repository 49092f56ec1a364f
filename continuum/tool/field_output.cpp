#include "continuum/tool/field_output.hpp"

#include "continuum/expect.hpp"
#include "continuum/tool/tool_model.hpp"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <fstream>

namespace continuum {

namespace {
using Part = dealii::DataComponentInterpretation::DataComponentInterpretation;

class StressFields : public dealii::DataPostprocessor<3> {
public:
  explicit StressFields(std::vector<ElasticMaterial> const& materials) : materials_(materials) {}

  void evaluate_vector_field(dealii::DataPostprocessorInputs::Vector<3> const& inputs,
                             std::vector<dealii::Vector<double>>& computed) const override {
    ElasticMaterial const& material = materials_[inputs.get_cell<3>()->material_id()];
    for (std::size_t q = 0; q < computed.size(); ++q) {
      Eigen::Matrix3d gradient;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          gradient(i, j) = inputs.solution_gradients[q][i][j];
      Eigen::Matrix3d const stress = material.stress(0.5 * (gradient + gradient.transpose()));
      Eigen::Vector3d const principal = principal_stresses(stress);
      for (int i = 0; i < 9; ++i)
        computed[q][i] = stress(i / 3, i % 3);
      computed[q][9] = von_mises(stress);
      for (int i = 0; i < 3; ++i)
        computed[q][10 + i] = principal[i];
    }
  }

  std::vector<std::string> get_names() const override {
    std::vector<std::string> names(9, "stress");
    names.push_back("von_mises");
    names.insert(names.end(), 3, "principal_stresses");
    return names;
  }
  std::vector<Part> get_data_component_interpretation() const override {
    std::vector<Part> parts(9, Part::component_is_part_of_tensor);
    parts.push_back(Part::component_is_scalar);
    parts.insert(parts.end(), 3, Part::component_is_part_of_vector);
    return parts;
  }
  dealii::UpdateFlags get_needed_update_flags() const override { return dealii::update_gradients; }

private:
  std::vector<ElasticMaterial> const& materials_;
};

// The vector element numbers its unknowns in its own way; cell by cell both are known.
dealii::Vector<double> as_field(ToolModel const& model, dealii::DoFHandler<3> const& vector_nodes,
                                Eigen::Matrix3Xd const& displacement) {
  dealii::FiniteElement<3> const& element = vector_nodes.get_fe();
  dealii::Vector<double> field(vector_nodes.n_dofs());
  std::vector<dealii::types::global_dof_index> unknowns(element.n_dofs_per_cell());
  for (auto const& cell : vector_nodes.active_cell_iterators()) {
    cell->get_dof_indices(unknowns);
    for (unsigned i = 0; i < unknowns.size(); ++i) {
      auto const [component, node] = element.system_to_component_index(i);
      field[unknowns[i]] = displacement(component, model.cells[cell->active_cell_index()][node]);
    }
  }
  return field;
}
} // namespace

void write_vtu(std::filesystem::path const& file, ElasticTool const& tool,
               Eigen::Matrix3Xd const& displacement) {
  ToolModel const& model = tool.mesh().model();
  dealii::FESystem<3> const element(model.element(), 3);
  dealii::DoFHandler<3> vector_nodes(model.triangulation());
  vector_nodes.distribute_dofs(element);
  dealii::Vector<double> const field = as_field(model, vector_nodes, displacement);
  StressFields const stress_fields(tool.materials());

  dealii::DataOut<3> out;
  dealii::DataOutBase::VtkFlags flags;
  flags.print_date_and_time = false; // the same tool gives the same bytes
  flags.write_higher_order_cells = true;
  out.set_flags(flags);
  out.attach_dof_handler(vector_nodes);
  out.add_data_vector(field, std::vector<std::string>(3, "displacement"),
                      dealii::DataOut<3>::type_dof_data,
                      std::vector<Part>(3, Part::component_is_part_of_vector));
  out.add_data_vector(field, stress_fields);
  out.build_patches(model.mapping(), 2, dealii::DataOut<3>::curved_inner_cells);

  std::filesystem::path const unfinished = file.string() + ".part";
  std::ofstream stream(unfinished);
  out.write_vtu(stream);
  stream.close();
  std::error_code error;
  if (stream)
    std::filesystem::rename(unfinished, file, error);
  VALIDATE(stream && !error, file.string() + ": cannot be written. Does the folder exist, and has "
                                             "the disk room?");
}

} // namespace continuum
