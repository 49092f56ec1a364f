#pragma once

#include "continuum/powder/dual.hpp"
#include "continuum/powder/elasticity.hpp"
#include "continuum/powder/powder_state.hpp"

#include <array>
#include <concepts>

/// A law as the return mapping sees it; only sources of laws include this.
namespace continuum::return_map {

/// The three unknowns and the two trial strains: what derivatives are taken by.
using Number = Dual<5>;

/// A yield function [Pa] and the direction of flow [-] of order one, at (p, q, eps_v^p).
template <class T> struct Face { T yield, flow_p, flow_q; };

/// The plastic strains of a step, compaction positive.
struct PlasticStep {
  double volumetric, deviatoric;
};

struct Trial {
  double volumetric, deviatoric;
  double compaction; ///< eps_v^p at the step's beginning
};

/// What a law offers to the mapping.
template <class L>
concept SurfaceLaw = requires(L const law, Number x, PowderSurface surface, double d) {
  { law.elastic(x, x, x) } -> std::same_as<StressPair<Number>>; // eps_v^e, eps_q^e, eps_v^p
  { law.yield(d, d, d) } -> std::same_as<double>;               // p, q, eps_v^p: > 0 outside
  { law.face(surface, x, x, x) } -> std::same_as<Face<Number>>;
  { law.edge(x, x, x) } -> std::same_as<std::array<Number, 2>>; // both zero on the edge
  { law.candidates(d, d, d) } -> std::same_as<std::array<PowderSurface, 5>>; // none: to be skipped
  { law.admits(surface, d, d, d, PlasticStep{}) } -> std::same_as<bool>;
  { law.density(d) } -> std::same_as<double>;
};

} // namespace continuum::return_map
