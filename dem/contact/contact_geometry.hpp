#pragma once

#include "dem/contact/pack.hpp"

namespace dem {

/// The sizes that a contact's constants depend on. At a tool the grain alone counts: effective
/// radius and mass are those of the grain.
struct PairSize {
  double effective_radius; ///< R* = Ri Rj / (Ri + Rj) [m]
  double effective_mass;   ///< m* = mi mj / (mi + mj) [kg]
  bool is_wall;
};

/// What a law sees of one contact. N is a number type of pack.hpp.
template <class N> struct ContactGeometry {
  N overlap;             ///< d [m]; > 0 where the law acts, or down to minus the law's reach
  N root_overlap;        ///< sqrt(d) [m^(1/2)], shared by the laws
  N distance;            ///< between the centres [m]
  N radius_i;            ///< [m]
  N radius_j;            ///< [m]
  N separation_velocity; ///< v.n [m/s], positive when the grains part
};

/// Answer of a normal law.
template <class N> struct NormalForce {
  N elastic;      ///< [N], without the dashpot
  N damping;      ///< [N], of the dashpot; elastic + damping pushes i along +normal
  N contact_root; ///< what a tangential law scales with: sqrt(d) for Hertz and Mindlin [m^(1/2)]
  N grip{0};      ///< [N], friction's limit is counted from minus this; plastic laws only
};

/// A normal law whose memory is the largest overlap d_m [m], and which loses energy as it grows.
template <class Law>
concept PlasticLaw = requires {
  requires Law::is_plastic;
};

} // namespace dem
