#pragma once

#include "dem/vec3.hpp"

/// What contacts need to know of their grains' other contacts: the formulas of multi_contact.hpp.
namespace dem {

/// What the contacts of a grain make of it.
template <class T> struct Crowding {
  T pressure;   ///< b K S / V [Pa]
  T per_volume; ///< b K / V [Pa/m^3]
};

/// v_c [m^3] of an overlap d [m] > 0.
template <class T> T displaced_volume(T effective_radius, T overlap) {
  return static_cast<T>(0.5 * pi) * effective_radius * overlap * overlap;
}

/// The force A_c (p_ic + p_jc) [N].
/// @param pressure, per_volume  sums of both grains' Crowding
template <class T> T crowding_force(T effective_radius, T overlap, T pressure, T per_volume) {
  T const own = per_volume * displaced_volume(effective_radius, overlap);
  return static_cast<T>(pi) * effective_radius * overlap * (pressure - own);
}

} // namespace dem
