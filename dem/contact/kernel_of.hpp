#pragma once

#include "dem/contact/sweep.hpp"

#include <cmath>

/// A composed contact model behind the table of functions of ContactKernel.
namespace dem::sweep_detail {

template <class Model, class T>
typename ContactKernel<T>::Energy energy_of(double const* row, double overlap, double memory,
                                            double radius_i, double radius_j) {
  using Normal = typename Model::NormalLaw;
  auto const c = from_row<Model>(row);
  if constexpr (PlasticLaw<Normal>) {
    auto const [seen, length] = Normal::area_overlap(c.normal, overlap, memory);
    return {Normal::energy(c.normal, overlap, memory),
            length * Model::CohesionLaw::energy(c.cohesion, seen, radius_i, radius_j)};
  } else {
    return {Normal::energy(c.normal, overlap),
            Model::CohesionLaw::energy(c.cohesion, overlap, radius_i, radius_j)};
  }
}

template <class Model, class T>
typename ContactKernel<T>::Stiffness stiffness_of(double const* row, double overlap,
                                                  [[maybe_unused]] double memory) {
  using Normal = typename Model::NormalLaw;
  auto const c = from_row<Model>(row);
  typename ContactKernel<T>::Stiffness s{};
  [[maybe_unused]] double seen = std::max(overlap, 0.0);
  if constexpr (PlasticLaw<Normal>) {
    seen = Normal::area_overlap(c.normal, overlap, memory).first;
    s.normal = Normal::tangent(c.normal, overlap, memory);
    s.normal_dashpot = Normal::dashpot(c.normal, overlap, memory);
  } else {
    s.normal = Normal::tangent(c.normal, overlap);
    s.normal_dashpot = Normal::dashpot(c.normal, overlap);
  }
  if constexpr (Model::has_spring) {
    double const root = std::sqrt(seen);
    s.tangential = Model::TangentialLaw::stiffness(c.tangential, root);
    s.tangential_dashpot = Model::TangentialLaw::dashpot(c.tangential, root);
  }
  return s;
}

template <class Model, class T> ContactKernel<T> kernel_of() {
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
      .energy = &energy_of<Model, T>,
      .stiffness = &stiffness_of<Model, T>};
}

} // namespace dem::sweep_detail
