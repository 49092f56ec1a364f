#pragma once

#include "dem/contact/contact_geometry.hpp"
#include "dem/material.hpp"

#include <string_view>

namespace dem {

/// No rolling resistance.
struct NoRolling {
  static constexpr std::string_view name = "none";
  static constexpr bool resists = false;
  static constexpr int n_constants = 0;

  template <class N> struct Constants {};

  static Constants<double> constants(PairMaterial const&, PairSize const&) { return {}; }
};

} // namespace dem
