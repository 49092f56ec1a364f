#pragma once

#include "dem/contact/cohesion/linear_area.hpp"
#include "dem/contact/cohesion/no_cohesion.hpp"
#include "dem/contact/cohesion/sjkr.hpp"
#include "dem/contact/normal/edinburgh.hpp"
#include "dem/contact/normal/hertz.hpp"
#include "dem/contact/normal/hooke.hpp"
#include "dem/contact/normal/jkr.hpp"
#include "dem/contact/normal/thornton_ning.hpp"
#include "dem/contact/rolling/constant_torque.hpp"
#include "dem/contact/rolling/no_rolling.hpp"
#include "dem/contact/tangential/frictionless.hpp"
#include "dem/contact/tangential/hooke_spring.hpp"
#include "dem/contact/tangential/mindlin.hpp"

#include <tuple>

/// The laws a case may name. Adding one is one header and one word here.
namespace dem {

template <class... Law> struct LawList {};

/// With which partners a normal law is composed: the laws that make physical sense beside it.
template <class Normal> struct Partners;

template <> struct Partners<Hertz> {
  using Cohesion = LawList<NoCohesion, LinearArea, Sjkr>;
  using Tangential = LawList<Frictionless, Mindlin>;
};
template <> struct Partners<Hooke> {
  using Cohesion = LawList<NoCohesion, LinearArea, Sjkr>;
  using Tangential = LawList<Frictionless, HookeSpring>;
};
/// JKR carries its own adhesion: a second cohesion would count it twice.
template <> struct Partners<Jkr> {
  using Cohesion = LawList<NoCohesion>;
  using Tangential = LawList<Frictionless, Mindlin>;
};
/// The energy that a plastic contact takes from cohesion is known where the area is linear.
template <> struct Partners<ThorntonNing> {
  using Cohesion = LawList<NoCohesion, LinearArea>;
  using Tangential = LawList<Frictionless, Mindlin>;
};
/// Edinburgh's law carries its own adhesion.
template <> struct Partners<Edinburgh> {
  using Cohesion = LawList<NoCohesion>;
  using Tangential = LawList<Frictionless, Mindlin>;
};

using NormalLaws = LawList<Hertz, Hooke, Jkr, ThorntonNing, Edinburgh>;
using RollingLaws = LawList<NoRolling, ConstantTorque>;

} // namespace dem
