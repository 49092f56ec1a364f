#pragma once

#include "dem/contact/contact_choice.hpp"
#include "dem/contact/contact_geometry.hpp"
#include "dem/contact/tangential/spring_slider.hpp"
#include "dem/material.hpp"

/// A contact model: a normal, a cohesion, a tangential and a rolling law composed by the compiler,
/// evaluated in one place and in one order: elastic and dashpot, then cohesion, then the friction
/// limit from their sum, then rolling.
namespace dem {

/// One contact as the sweep gathered it; N is a number type of pack.hpp.
template <class N> struct ContactInput {
  Triple<N> separation; ///< x_i - x_j [m]
  N square_gap; ///< (R_i + R_j)^2 - r^2, formed in double [m^2]: keeps small overlaps in float
  N radius_sum; ///< [m]
  N radius_i, radius_j;     ///< [m]
  Triple<N> velocity;       ///< v_i - v_j [m/s]
  Triple<N> spin_i, spin_j; ///< [rad/s]
  N crowding{0};            ///< [N], by other contacts of the two grains, see multi_contact.hpp
};

template <class N> struct ContactOutput {
  Triple<N> force;    ///< on i [N]; on j the opposite
  Triple<N> torque_i; ///< [N m]
  Triple<N> torque_j; ///< [N m]
  N normal_force;     ///< along the normal, all parts [N]
  N cohesive_force;   ///< [N]
  N overlap;          ///< [m]
  N normal_loss;      ///< power lost in the normal dashpot [W]
  N tangential_power; ///< power put into spring, dashpot and slider [W]
  N rolling_loss;     ///< [W]
  N plastic_work;     ///< lost to plastic deformation in this step [J]
};

/// What a contact remembers from step to step.
template <class N> struct ContactMemory {
  Triple<N> spring; ///< tangential spring xi [m]
  N normal;         ///< the normal law's own memory
};

/// Options of the model that are not laws, as numbers.
template <class N> struct ModelSwitches {
  N cohesion_in_limit; ///< 1: friction limit from elastic + dashpot + cohesion; 0: without cohesion
  N clip;              ///< 1: elastic + dashpot never attracts
  N viscous_time;      ///< A [s]: a dashpot A dF/dd beside the law's own
};

template <class Normal, class Cohesion, class Tangential, class Rolling> struct ContactModel {
  using NormalLaw = Normal;
  using CohesionLaw = Cohesion;
  using TangentialLaw = Tangential;
  using RollingLaw = Rolling;
  static constexpr bool has_memory = Normal::has_memory;
  static constexpr bool has_spring = Tangential::has_spring;
  static constexpr int n_constants =
      Normal::n_constants + Cohesion::n_constants + Tangential::n_constants + Rolling::n_constants;

  template <class N> struct Constants {
    typename Normal::template Constants<N> normal;
    typename Cohesion::template Constants<N> cohesion;
    typename Tangential::template Constants<N> tangential;
    typename Rolling::template Constants<N> rolling;
  };

  static Constants<double> constants(PairMaterial const& pair, PairSize const& size,
                                     ContactChoice const& choice) {
    return {Normal::constants(pair, size, choice), Cohesion::constants(pair, size, choice.cohesion),
            Tangential::constants(pair, size, choice), Rolling::constants(pair, size)};
  }

  /// @param dt  step [s]; 0 leaves the springs as they are
  template <class N>
  static ContactOutput<N> evaluate(ContactInput<N> const& in, Constants<N> const& constants,
                                   ModelSwitches<N> const& switches, N const& dt,
                                   ContactMemory<N>& memory) {
    N const r = square_root(dot(in.separation, in.separation));
    Triple<N> const n = (N(1) / r) * in.separation;
    N const overlap = in.square_gap / (in.radius_sum + r);
    N const lever_i = in.radius_i - N(0.5f) * overlap;
    N const lever_j = in.radius_j - N(0.5f) * overlap;
    N const separation_velocity = dot(in.velocity, n);
    ContactGeometry<N> const geometry{.overlap = overlap,
                                      .root_overlap = square_root(larger(overlap, N(0))),
                                      .distance = r,
                                      .radius_i = in.radius_i,
                                      .radius_j = in.radius_j,
                                      .separation_velocity = separation_velocity};

    N const before = memory.normal;
    NormalForce<N> const normal = Normal::force(constants.normal, geometry, memory.normal);
    N const viscous =
        switches.viscous_time * Normal::tangent_at(constants.normal, normal.contact_root);
    auto acts = overlap > N(0);
    if constexpr (has_memory)
      acts = acts || memory.normal > N(0.5f);
    N const elastic = normal.elastic + in.crowding;
    N repulsion = elastic + normal.damping - viscous * separation_velocity;
    repulsion = select(switches.clip > N(0.5f), larger(repulsion, N(0)), repulsion);
    ContactGeometry<N> of_area = geometry;
    if constexpr (PlasticLaw<Normal>) {
      of_area.root_overlap = normal.contact_root;
      of_area.overlap = normal.contact_root * normal.contact_root;
    }
    N const cohesion = select(overlap > N(0), Cohesion::force(constants.cohesion, of_area), N(0));
    N const normal_force = select(acts, repulsion + cohesion, N(0));

    ContactOutput<N> out{};
    out.overlap = overlap;
    out.normal_force = normal_force;
    out.cohesive_force = select(acts, cohesion, N(0));
    out.force = normal_force * n;
    out.normal_loss = select(acts, (elastic - repulsion) * separation_velocity, N(0));
    if constexpr (PlasticLaw<Normal>) {
      auto const cohesion_at = [&](N const& d) {
        of_area.overlap = d;
        return Cohesion::force(constants.cohesion, of_area);
      };
      out.plastic_work =
          select(memory.normal > before,
                 Normal::dissipated(constants.normal, before, memory.normal, cohesion_at), N(0));
    }

    if constexpr (has_spring) {
      Triple<N> const surface_spin = lever_i * in.spin_i + lever_j * in.spin_j;
      Triple<N> const slip = in.velocity - separation_velocity * n - cross(surface_spin, n);
      N held = repulsion + switches.cohesion_in_limit * cohesion;
      if constexpr (PlasticLaw<Normal>)
        held = held + normal.grip;
      N const limit = constants.tangential.friction * magnitude(held);
      Triple<N> spring = memory.spring;
      TangentialForce<N> tangential =
          spring_slider(Tangential::stiffness(constants.tangential, normal.contact_root),
                        Tangential::dashpot(constants.tangential, normal.contact_root), limit, n,
                        slip, dt, spring);
      Triple<N> const zero{N(0), N(0), N(0)};
      memory.spring = select(acts, spring, zero);
      Triple<N> const force = select(acts, tangential.force, zero);
      Triple<N> const moment = cross(n, force);
      out.force = out.force + force;
      out.torque_i = (-lever_i) * moment;
      out.torque_j = (-lever_j) * moment;
      out.tangential_power =
          select(acts, -(dot(tangential.mean_spring, slip) + dot(tangential.dashpot, slip)), N(0));
    }
    if constexpr (Rolling::resists) {
      Triple<N> const relative = in.spin_i - in.spin_j;
      Triple<N> const torque =
          select(acts, N(1), N(0)) * Rolling::torque(constants.rolling, elastic, n, relative);
      out.torque_i = out.torque_i + torque;
      out.torque_j = out.torque_j - torque;
      out.rolling_loss = -dot(torque, relative);
    }
    return out;
  }
};

} // namespace dem
