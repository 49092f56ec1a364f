#pragma once

#include "continuum/powder/surface_law.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

/// The equations of one step on one surface, and Newton's iteration for them; see return_map.hpp.
namespace continuum::return_map {

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

} // namespace continuum::return_map
