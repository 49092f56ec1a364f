#pragma once

#include "continuum/powder/local_newton.hpp"

#include <array>
#include <optional>

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
  // A point that stands on its surface is outside by rounding, where no plastic step would end.
  double const rounding = 1e-14 * (stress.p.slope[0] + stress.q.slope[1]);
  if (!(law.yield(stress.p.value, stress.q.value, trial.compaction) <= rounding))
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
