#pragma once

#include "continuum/powder/dual.hpp"
#include "continuum/powder/elasticity.hpp"
#include "continuum/powder/powder_state.hpp"

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <optional>
#include <span>

/// Fully implicit return mapping of an isotropic law in p and q; only sources of laws include this.
///
/// Strains of the step, compaction positive:  eps_v = -tr eps,  eps_q = sqrt(2/3) |dev eps|.
/// Isotropy keeps the direction of the trial deviator, so a step has three unknowns, elastic
/// strains and multiplier y = (eps_v^e, eps_q^e, dl), and three equations on a surface f with flow
/// m:
///     eps_v^e - eps_v^tr + dl m_p = 0,   eps_q^e - eps_q^tr + dl m_q = 0,   f(p, q, eps_v^p) = 0,
/// where eps_v^p = eps_v^p_old + eps_v^tr - eps_v^e follows the step: elasticity, hardening and all
/// properties are those of its end. On an edge two yield functions replace the flow.
/// Source: Simo and Hughes (1998), ch. 3; de Souza Neto, Peric and Owen (2008), ch. 8.
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

struct Equations {
  Eigen::Vector3d residual;
  Eigen::Matrix<double, 3, 5> slope; ///< by the unknowns and the trial strains
  StressPair<Number> stress;
};

/// The equations at y; a yield function is divided by a modulus [Pa] and so a strain, too.
template <SurfaceLaw L>
Equations equations(L const& law, PowderSurface surface, Trial const& trial, double modulus,
                    Eigen::Vector3d const& y) {
  auto const v = Number::variable(y[0], 0), q = Number::variable(y[1], 1);
  auto const multiplier = Number::variable(y[2], 2);
  auto const v_trial = Number::variable(trial.volumetric, 3);
  auto const q_trial = Number::variable(trial.deviatoric, 4);
  Number const compaction = trial.compaction + v_trial - v;
  auto const stress = law.elastic(v, q, compaction);

  std::array<Number, 3> rows;
  if (surface == PowderSurface::edge) {
    auto const [first, second] = law.edge(stress.p, stress.q, compaction);
    rows = {first / modulus, second / modulus, multiplier};
  } else {
    auto const face = law.face(surface, stress.p, stress.q, compaction);
    rows = {v - v_trial + multiplier * face.flow_p, q - q_trial + multiplier * face.flow_q,
            face.yield / modulus};
  }
  Equations result{.residual = {}, .slope = {}, .stress = stress};
  for (int i = 0; i < 3; ++i) {
    result.residual[i] = rows[i].value;
    result.slope.row(i) = rows[i].slope.transpose();
  }
  return result;
}

struct Solution {
  Eigen::Vector3d y;
  Equations at;
};

/// What a failure tells.
struct Effort {
  int n_iterations = 0;
  double least_residual = INFINITY;
};

/// Newton's iteration with halved steps; ends with one more step after convergence, so that the
/// stress is good to rounding and not to a tolerance.
template <SurfaceLaw L>
std::optional<Solution> solve(L const& law, PowderSurface surface, Trial const& trial,
                              double modulus, Eigen::Vector3d y, Effort& effort) {
  constexpr double tolerance = 1e-11;
  constexpr int n_iterations = 60, n_halvings = 12;
  auto now = equations(law, surface, trial, modulus, y);
  bool is_close = false;
  for (int i = 0; i < n_iterations && now.residual.allFinite(); ++i) {
    double const size = now.residual.norm();
    effort.least_residual = std::min(effort.least_residual, size);
    Eigen::Vector3d const step =
        now.slope.template leftCols<3>().partialPivLu().solve(-now.residual);
    if (!step.allFinite())
      return std::nullopt;
    ++effort.n_iterations;
    double part = 1.0;
    auto next = equations(law, surface, trial, modulus, y + step);
    for (int k = 0; k < n_halvings && !(next.residual.norm() < size); ++k) {
      part /= 2.0;
      next = equations(law, surface, trial, modulus, y + part * step);
    }
    bool const gains = next.residual.norm() < size;
    if (gains) {
      y += part * step;
      now = next;
    }
    if (is_close || (!gains && size < tolerance))
      return Solution{y, now};
    if (!gains)
      return std::nullopt;
    is_close = now.residual.norm() < tolerance;
  }
  return std::nullopt;
}

/// Second guess: the trial's elastic strain scaled down to the surface, with the density of the
/// step's beginning. A trial far outside sees a bed much softer than the one it ends in.
template <SurfaceLaw L> Eigen::Vector3d scaled_guess(L const& law, Trial const& trial) {
  double inside = 0.0, outside = 1.0;
  for (int i = 0; i < 40; ++i) {
    double const middle = (inside + outside) / 2.0;
    auto const stress =
        law.elastic(middle * trial.volumetric, middle * trial.deviatoric, trial.compaction);
    (law.yield(stress.p, stress.q, trial.compaction) > 0.0 ? outside : inside) = middle;
  }
  return {inside * trial.volumetric, inside * trial.deviatoric,
          (1.0 - inside) * std::hypot(trial.volumetric, trial.deviatoric)};
}

/// Stiffness [Pa] at an elastic strain, which makes a strain of a yield function. Not that of the
/// trial: where it follows the pressure, it would be beyond measure there.
template <SurfaceLaw L>
double modulus_at(L const& law, Eigen::Vector3d const& y, double compaction) {
  using Pair = Dual<2>;
  auto const stress =
      law.elastic(Pair::variable(y[0], 0), Pair::variable(y[1], 1), Pair(compaction));
  return stress.p.slope[0] + stress.q.slope[1];
}

/// d(p, q)/d(eps_v^tr, eps_q^tr) [Pa] at the end of a step.
inline Eigen::Matrix2d invariant_tangent(Equations const& at) {
  Eigen::Matrix<double, 3, 2> const follow =
      -at.slope.leftCols<3>().partialPivLu().solve(at.slope.rightCols<2>());
  Eigen::Matrix<double, 2, 5> by;
  by << at.stress.p.slope.transpose(), at.stress.q.slope.transpose();
  return by.leftCols<3>() * follow + by.rightCols<2>();
}

/// Trial strain in invariants and the direction of its deviator.
struct Split {
  Trial trial;
  Eigen::Vector3d direction; ///< unit deviator, zero if there is none
};
Split split(Eigen::Vector3d const& trial_strain, double compaction);

/// What the invariants of a step's end say of it in principal axes.
struct End {
  double p, q;                          ///< [Pa]
  double elastic_volume, elastic_shear; ///< eps_v^e, eps_q^e [-]
  Eigen::Matrix2d tangent;              ///< of invariant_tangent [Pa]
  PowderSurface surface;
};
PowderResponse respond(Split const& split, End const& end);

template <SurfaceLaw L>
std::optional<PowderResponse> elastic_step(L const& law, Split const& split) {
  Trial const& trial = split.trial;
  using Pair = Dual<2>;
  auto const stress = law.elastic(Pair::variable(trial.volumetric, 0),
                                  Pair::variable(trial.deviatoric, 1), Pair(trial.compaction));
  if (!(law.yield(stress.p.value, stress.q.value, trial.compaction) <= 0.0))
    return std::nullopt;
  Eigen::Matrix2d tangent;
  tangent << stress.p.slope.transpose(), stress.q.slope.transpose();
  return respond(split, {.p = stress.p.value,
                         .q = stress.q.value,
                         .elastic_volume = trial.volumetric,
                         .elastic_shear = trial.deviatoric,
                         .tangent = tangent,
                         .surface = PowderSurface::none});
}

/// The step's end if a solution on a surface is one: within its part, with flow forwards.
template <SurfaceLaw L>
std::optional<PowderResponse> plastic_end(L const& law, PowderSurface surface, Split const& split,
                                          Solution const& solution) {
  Trial const& trial = split.trial;
  auto const& [y, at] = solution;
  double const p = at.stress.p.value, q = at.stress.q.value;
  PlasticStep const flow{.volumetric = trial.volumetric - y[0],
                         .deviatoric = trial.deviatoric - y[1]};
  double const compaction = trial.compaction + flow.volumetric;
  // At an apex the elastic shear is zero, to rounding.
  if (y[1] < -1e-13 || y[2] < 0.0 || !law.admits(surface, p, q, compaction, flow))
    return std::nullopt;
  return respond(split, {.p = p,
                         .q = q,
                         .elastic_volume = y[0],
                         .elastic_shear = y[1],
                         .tangent = invariant_tangent(at),
                         .surface = surface});
}

/// One step of a law: elastic if the trial stays inside, else the first surface that gives an
/// admissible end.
template <SurfaceLaw L>
PowderResult map_back(L const& law, PowderState const& old, Eigen::Vector3d const& trial_strain) {
  Split const parts = split(trial_strain, old.plastic_compaction);
  Trial const& trial = parts.trial;
  if (auto const response = elastic_step(law, parts))
    return *response;
  auto const stress = law.elastic(trial.volumetric, trial.deviatoric, trial.compaction);
  Eigen::Vector3d const scaled = scaled_guess(law, trial);
  double const modulus = modulus_at(law, scaled, trial.compaction);
  Effort effort;
  bool is_solid = false;
  // First guess the trial, then the scaled one, then where a neighbouring surface has ended outside
  // its part: the transition is a short arc, which Newton's iteration may miss from afar.
  std::array<Eigen::Vector3d, 3> guesses = {
      Eigen::Vector3d(trial.volumetric, trial.deviatoric, 0.0), scaled, scaled};
  for (auto const& guess : guesses)
    for (PowderSurface const surface : law.candidates(stress.p, stress.q, trial.compaction)) {
      if (surface == PowderSurface::none)
        continue;
      auto const solution = solve(law, surface, trial, modulus, guess, effort);
      if (!solution)
        continue;
      auto const response = plastic_end(law, surface, parts, *solution);
      if (response && law.density(response->state.plastic_compaction) < 1.0)
        return *response;
      is_solid = is_solid || response;
      if (surface == PowderSurface::shear)
        guesses[2] = solution->y;
    }
  using Reason = PowderFailure::Reason;
  return PowderFailure{.reason = is_solid ? Reason::density_above_one : Reason::no_convergence,
                       .n_iterations = effort.n_iterations,
                       .least_residual = effort.least_residual,
                       .relative_density = law.density(trial.compaction)};
}

} // namespace continuum::return_map
