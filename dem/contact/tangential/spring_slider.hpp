#pragma once

#include "dem/contact/contact_geometry.hpp"

namespace dem {

/// What a tangential law answers: force on grain i [N] and the part of it that the spring carried
/// before this step's slip increment (for the energy book).
template <class N> struct TangentialForce {
  Triple<N> force;
  Triple<N> mean_spring; ///< mean of the spring force over the step, dashpot excluded [N]
  Triple<N> dashpot;     ///< [N]
};

/// The spring, dashpot and slider shared by every tangential law with history.
///   1) xi += v_t dt   2) xi -= (xi.n) n   3) F = -k xi with the present k
///   4) if |k xi| > L:  F scaled to L, xi := -F/k, no dashpot;  else F -= c v_t (the sum is not
///   clipped again)
/// The spring turns with the contact by projection; its length is not restored, as in LIGGGHTS.
/// @param spring  xi [m], changed
/// @param limit   L = mu |F_lim| [N]
template <class N>
TangentialForce<N> spring_slider(N const& stiffness, N const& damping, N const& limit,
                                 Triple<N> const& normal, Triple<N> const& slip_velocity,
                                 N const& dt, Triple<N>& spring) {
  Triple<N> const increment = dt * slip_velocity;
  Triple<N> const stretched = spring + increment;
  Triple<N> const trial = stretched - dot(stretched, normal) * normal;
  N const trial_force = stiffness * square_root(dot(trial, trial));
  auto const slides = trial_force > limit;
  N const kept = select(slides, limit / larger(trial_force, N(1e-30f)), N(1));
  spring = kept * trial;
  Triple<N> const before = trial - increment;
  Triple<N> const dashpot = select(slides, N(0), -damping) * slip_velocity;
  Triple<N> const force = (-stiffness) * spring;
  return {.force = force + dashpot,
          .mean_spring = (N(-0.5f) * stiffness) * (spring + before),
          .dashpot = dashpot};
}

} // namespace dem
