#pragma once

#include "dem/contact/sweep.hpp"

#include <cmath>

/// A composed contact model behind the table of functions of ContactKernel.
namespace dem::sweep_detail {

template <class Model, class T> ContactKernel<T> kernel_of() {
  using Kernel = ContactKernel<T>;
  return {
      .n_constants = Model::n_constants,
      .has_memory = Model::has_memory,
      .constants = &write_constants<Model>,
      .reach =
          [](double const* row) { return Model::NormalLaw::reach(from_row<Model>(row).normal); },
      .sweep = &sweep<Model, T>,
      .evaluate =
          [](ContactInput<double> const& in, double const* row,
             ModelSwitches<double> const& switches, ContactMemory<double> memory) {
            return Model::evaluate(in, from_row<Model>(row), switches, 0.0, memory);
          },
      .energy =
          [](double const* row, double overlap, double radius_i, double radius_j) {
            auto const c = from_row<Model>(row);
            return typename Kernel::Energy{
                Model::NormalLaw::energy(c.normal, overlap),
                Model::CohesionLaw::energy(c.cohesion, overlap, radius_i, radius_j)};
          },
      .stiffness =
          [](double const* row, double overlap) {
            auto const c = from_row<Model>(row);
            typename Kernel::Stiffness s{Model::NormalLaw::tangent(c.normal, overlap), 0.0,
                                         Model::NormalLaw::dashpot(c.normal, overlap), 0.0};
            if constexpr (Model::has_spring) {
              double const root = std::sqrt(std::max(overlap, 0.0));
              s.tangential = Model::TangentialLaw::stiffness(c.tangential, root);
              s.tangential_dashpot = Model::TangentialLaw::dashpot(c.tangential, root);
            }
            return s;
          }};
}

} // namespace dem::sweep_detail
